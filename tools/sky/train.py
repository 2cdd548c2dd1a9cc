"""Train the sky network on the CPU.

    python tools/sky/train.py DATA --out FOLDER [--minutes 60] [--leave-out pseudo khumbu] [--seed 0] [--threads 1]

DATA holds `mmp`, `uav` and so on, each with `images` and `labels` (tools/sky/DATA.md). Needs PyTorch and OpenCV.
FOLDER receives `last.pt` every few minutes and is gone on with where it exists. --minutes are of the processor, over
all runs, so that a busy machine only takes longer; the learning rate falls along a cosine to their end. `final.pt`
holds the averaged weights with batch statistics of their own; `tools/sky/export.py` turns it into the file that the
plugin reads.
"""

from __future__ import annotations

import argparse
import copy
import json
import math
import multiprocessing
import time
from pathlib import Path

import augment
import cv2
import data
import numpy as np
import skies
import torch
from network import SkyNetwork
from skyline_viewshed.core.skyline.network import network_input
from torch.nn import functional

BATCH = 16
LEARNING_RATE = 3e-3
LEAST_RATE = 1e-6
WARM_UP = 0.03
DECAY = 0.998
SAVE_EVERY_S = 240


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data", type=Path)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--minutes", type=float, default=60)
    parser.add_argument("--leave-out", nargs="*", default=["pseudo", "khumbu"], help="sets that do not train")
    parser.add_argument("--start", type=Path, help="weights to start from")
    parser.add_argument("--rate", type=float, default=LEARNING_RATE)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--threads", type=int, default=1)
    return parser.parse_args()


def training_pictures(folder, leave_out):
    """Pictures of all sets that are there and not left out, without those held out."""
    sets = [source for source in data.SET_WEIGHTS if source not in leave_out and (folder / source).is_dir()]
    held_out = data.held_out()
    return [p for source in sets for p in data.load(folder, source) if p.name not in held_out.get(source, ())]


def keep_making(queue, pictures, seed):
    """Put batches into a queue for ever (a process of its own)."""
    generator = np.random.default_rng(seed)
    chances = data.draw_weights(pictures)
    patches = [patch for patch in map(skies.sky_patch, pictures) if patch is not None]
    while True:
        shape = augment.SHAPES[generator.integers(len(augment.SHAPES))]
        made = [augment.sample(generator, pictures, chances, patches, shape) for _ in range(BATCH)]
        queue.put(tuple(np.stack(part) for part in zip(*made)))


def tensors(batch):
    """Input, target and weights of a batch."""
    pixels, sky, weight = batch
    values = np.stack([network_input(picture) for picture in pixels]).transpose(0, 3, 1, 2)
    return (
        torch.from_numpy(np.ascontiguousarray(values)).to(memory_format=torch.channels_last),
        torch.from_numpy(sky.astype(np.float32))[:, None],
        torch.from_numpy(weight.astype(np.float32))[:, None],
    )


def loss_of(network, batch):
    """Weighted cross-entropy of a batch at full size."""
    values, sky, weight = tensors(batch)
    with torch.autocast("cpu", torch.bfloat16):
        logit = network(values)
    logit = functional.interpolate(logit.float(), scale_factor=2, mode="bilinear", align_corners=False)
    loss = functional.binary_cross_entropy_with_logits(logit, sky, reduction="none")
    return (loss * weight).sum() / weight.sum().clamp(min=1)


def average_into(mean, network, step):
    """Move the running mean of the weights a little towards the network's."""
    keep = min(DECAY, (1 + step) / (10 + step))
    with torch.no_grad():
        for old, new in zip(mean.parameters(), network.parameters()):
            old.mul_(keep).add_(new, alpha=1 - keep)
        for old, new in zip(mean.buffers(), network.buffers()):
            old.copy_(new)


def renew_statistics(mean, queue, batches=60):
    """Measure the batch statistics of averaged weights."""
    mean.train()
    for module in mean.modules():
        if isinstance(module, torch.nn.BatchNorm2d):
            module.reset_running_stats()
            module.momentum = None
    with torch.no_grad():
        for _ in range(batches):
            mean(tensors(queue.get())[0])
    return mean.eval()


class Training:
    """Network, running mean, optimiser and the time spent; saved and loaded together."""

    def __init__(self, options):
        torch.manual_seed(options.seed)
        self.options = options
        self.network = SkyNetwork().to(memory_format=torch.channels_last)
        if options.start:
            self.network.load_state_dict(torch.load(options.start))
        self.mean = copy.deepcopy(self.network)
        self.optimiser = torch.optim.AdamW(self.network.parameters(), lr=options.rate, weight_decay=1e-2)
        self.step, self.spent_s, self.running_loss = 0, 0.0, None
        self.path = options.out / "last.pt"
        if self.path.exists():
            self._load()

    def _load(self):
        state = torch.load(self.path)
        self.network.load_state_dict(state["network"])
        self.mean.load_state_dict(state["mean"])
        self.optimiser.load_state_dict(state["optimiser"])
        self.step, self.spent_s, self.running_loss = state["step"], state["spent_s"], state["running_loss"]

    def save(self):
        """Write all of it, whole or not at all."""
        state = {"network": self.network.state_dict(), "mean": self.mean.state_dict()}
        state.update(optimiser=self.optimiser.state_dict(), step=self.step, spent_s=self.spent_s)
        torch.save({**state, "running_loss": self.running_loss}, self.path.with_suffix(".new"))
        self.path.with_suffix(".new").replace(self.path)

    def advance(self, batch):
        """One step of the optimiser."""
        done = min(1.0, self.spent_s / (self.options.minutes * 60))
        falling = 0.5 + 0.5 * math.cos(math.pi * done)
        rate = self.options.rate * min(1.0, done / WARM_UP) * falling + LEAST_RATE
        for part in self.optimiser.param_groups:
            part["lr"] = rate
        loss = loss_of(self.network, batch)
        self.optimiser.zero_grad()
        loss.backward()
        torch.nn.utils.clip_grad_norm_(self.network.parameters(), 1.0)
        self.optimiser.step()
        self.step += 1
        value = loss.item()
        self.running_loss = value if self.running_loss is None else 0.99 * self.running_loss + 0.01 * value
        average_into(self.mean, self.network, self.step)


def main():
    options = arguments()
    options.out.mkdir(parents=True, exist_ok=True)
    cv2.setNumThreads(0)  # its threads do not survive the fork of the process that makes batches
    torch.set_num_threads(options.threads)
    pictures = training_pictures(options.data, options.leave_out)
    counts = {source: sum(p.source == source for p in pictures) for source in data.SET_WEIGHTS}
    training = Training(options)
    print(f"pictures {counts}; starts at step {training.step}", flush=True)
    queue = multiprocessing.Queue(4)
    maker = multiprocessing.Process(
        target=keep_making, args=(queue, pictures, [options.seed, training.step]), daemon=True
    )
    maker.start()
    saved = time.monotonic()
    while training.spent_s < options.minutes * 60:
        before = time.process_time()
        training.advance(queue.get())
        training.spent_s += time.process_time() - before
        if time.monotonic() - saved > SAVE_EVERY_S:
            saved = time.monotonic()
            training.save()
            print(f"{training.spent_s:6.0f} s, step {training.step}, loss {training.running_loss:.4f}", flush=True)
    training.save()
    torch.save(renew_statistics(training.mean, queue).state_dict(), options.out / "final.pt")
    maker.terminate()
    used = {"pictures": counts, "steps": training.step, "seconds": round(training.spent_s), "seed": options.seed}
    (options.out / "origin.json").write_text(json.dumps({**used, "loss": round(training.running_loss, 4)}))
    print(f"done: {used}, loss {training.running_loss:.4f}", flush=True)


if __name__ == "__main__":
    main()
