"""The network in PyTorch, for training only; `core/skyline/network.py` runs it in NumPy."""

from __future__ import annotations

import torch
from torch import nn
from torch.nn import functional

WIDTHS = (16, 32, 48, 64, 80)
"""Channels of the five levels, each at half the size of the one above."""

LAST_WIDTHS = (48, 32, 24, 16)
"""Channels on the way up again."""


class Step(nn.Sequential):
    """3 x 3 convolution, batch normalisation and rectifier."""

    def __init__(self, channels_in, channels_out, stride=1):
        convolution = nn.Conv2d(channels_in, channels_out, 3, stride, 1, bias=False)
        super().__init__(convolution, nn.BatchNorm2d(channels_out), nn.ReLU(True))


class SkyNetwork(nn.Module):
    """U-Net with a global mean: (N, 4, H, W) to log-odds of sky (N, 1, H / 2, W / 2).

    The channels are those of `core.skyline.network.network_input`; H and W are multiples of 32.
    """

    def __init__(self):
        super().__init__()
        downs, channels = [], 4
        for level, width in enumerate(WIDTHS):
            steps = [Step(channels, width, 2), Step(width, width)]
            downs.append(nn.Sequential(*steps, *([Step(width, width)] if level == len(WIDTHS) - 1 else [])))
            channels = width
        self.downs = nn.ModuleList(downs)
        self.everywhere = nn.Conv2d(channels, channels, 1)
        ups = []
        for skip, width in zip(WIDTHS[-2::-1], LAST_WIDTHS):
            ups.append(Step(channels + skip, width))
            channels = width
        self.ups = nn.ModuleList(ups)
        self.last = nn.Conv2d(channels, 1, 3, 1, 1)

    def forward(self, x):
        """Log-odds of sky at half size."""
        skips = []
        for down in self.downs:
            x = down(x)
            skips.append(x)
        x = functional.relu(x + self.everywhere(x.mean((2, 3), keepdim=True)))
        for up, skip in zip(self.ups, skips[-2::-1]):
            x = up(torch.cat([functional.interpolate(x, scale_factor=2, mode="nearest"), skip], 1))
        return self.last(x)
