"""Write a trained network as plain numbers that the plugin reads without PyTorch.

    python tools/sky/export.py final.pt [--out core/skyline/sky_network.npz]

Batch normalisation is folded into the convolutions; kernels become half-precision matrices (taps x channels in,
channels out), taps row by row. A checkpoint (`last.pt`) may be given too: its running mean is written. With --golden
PyTorch's answer to a painted picture is kept as well, with which `tests/core/skyline/test_network.py` compares NumPy's.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import cv2
import numpy as np
import torch
from network import SkyNetwork, Step
from skyline_viewshed.core.skyline.network import network_input

ROOT = Path(__file__).resolve().parent.parent.parent
LARGEST_BYTES = 1_000_000
GOLDEN_PATH = ROOT / "tests" / "core" / "skyline" / "golden_sky.npz"
GOLDEN_SHAPE = (96, 128)


def read(path):
    """The network in a file of weights or a checkpoint, ready to be used."""
    state = torch.load(path)
    network = SkyNetwork()
    network.load_state_dict(state.get("mean", state))
    return network.eval()


def folded(step):
    """Kernel and bias of a convolution with its batch normalisation."""
    convolution, norm = step[0], step[1]
    factor = norm.weight / torch.sqrt(norm.running_var + norm.eps)
    return convolution.weight * factor[:, None, None, None], norm.bias - norm.running_mean * factor


def layers_of(network):
    """Map of a layer's name to the `Step` or the plain convolution."""
    found = {f"down{level}.{n}": step for level, down in enumerate(network.downs) for n, step in enumerate(down)}
    found.update({f"up{level}": step for level, step in enumerate(network.ups)})
    return {**found, "everywhere": network.everywhere, "last": network.last}


def numbers(network):
    """Arrays as `core.skyline.network.load_layers` wants them."""
    out = {}
    with torch.no_grad():
        for name, layer in layers_of(network).items():
            kernel, bias = folded(layer) if isinstance(layer, Step) else (layer.weight, layer.bias)
            matrix = kernel.permute(2, 3, 1, 0).reshape(-1, kernel.shape[0])
            out[f"{name}.kernel"] = matrix.numpy().astype(np.float16)
            out[f"{name}.bias"] = bias.numpy().astype(np.float32)
    return out


def use_rounded(network, arrays):
    """Give the network the numbers as they are written, so that it answers as the plugin must."""
    with torch.no_grad():
        for name, layer in layers_of(network).items():
            kernel, bias = arrays[f"{name}.kernel"].astype(np.float32), arrays[f"{name}.bias"]
            convolution, norm = (layer[0], layer[1]) if isinstance(layer, Step) else (layer, layer)
            shape = convolution.weight.shape
            matrix = torch.from_numpy(kernel).reshape(*shape[2:], shape[1], shape[0])
            convolution.weight.copy_(matrix.permute(3, 2, 0, 1))
            norm.bias.copy_(torch.from_numpy(bias))
            if isinstance(layer, Step):
                norm.weight.fill_(1)
                norm.running_mean.fill_(0)
                norm.running_var.fill_(1 - norm.eps)


def write_golden(network):
    """Keep a painted picture and the log-odds that PyTorch gives for it."""
    height, width = GOLDEN_SHAPE
    generator = np.random.default_rng(1)
    sky, rock = (
        cv2.resize(generator.uniform(low, high, (6, 8, 3)), (width, height), interpolation=cv2.INTER_CUBIC)
        for low, high in (((100, 140, 190), (140, 170, 230)), ((40, 35, 30), (110, 90, 70)))
    )
    ridge = 40 + 15 * np.sin(np.arange(width) / 12) + 4 * np.sin(np.arange(width) / 3)
    pixels = np.where((np.arange(height)[:, None] < ridge)[..., None], sky, rock)
    pixels = np.clip(pixels, 0, 255).astype(np.uint8)
    values = torch.from_numpy(network_input(pixels).transpose(2, 0, 1)[None].copy())
    with torch.no_grad():
        log_odds = network(values)[0, 0].numpy()
    np.savez_compressed(GOLDEN_PATH, pixels=pixels, log_odds=log_odds)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("weights", type=Path)
    parser.add_argument("--out", type=Path, default=ROOT / "core" / "skyline" / "sky_network.npz")
    parser.add_argument("--golden", action="store_true", help="renew tests/core/skyline/golden_sky.npz")
    options = parser.parse_args()
    network = read(options.weights)
    arrays = numbers(network)
    np.savez_compressed(options.out, **arrays)
    size = options.out.stat().st_size
    print(f"{options.out}: {sum(v.size for v in arrays.values())} numbers, {size} bytes")
    if size > LARGEST_BYTES:
        raise SystemExit(f"That is more than {LARGEST_BYTES} bytes.")
    if options.golden:
        use_rounded(network, arrays)
        write_golden(network)


if __name__ == "__main__":
    main()
