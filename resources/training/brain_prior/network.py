"""The prior's network: a U-Net on a grid of 8 mm whose voxels carry 2 x 2 x 2 voxels of 4 mm as channels."""
import torch
from torch import nn
from torch.nn import functional

SIZE = (48, 56, 48)  # voxels of 4 mm, RAS: the window about the head
SPACING_MM = 4.0
CLASSES = 4  # air, brain with closed sulci, fluid around it, the rest of the head
CHANNELS = (48, 64, 64)
SLOPE = 0.1  # of the leaky rectifier


def fold_voxels(image):
    """(N, 1, X, Y, Z) -> (N, 8, X/2, Y/2, Z/2); channel 4 dx + 2 dy + dz."""
    n, _, x, y, z = image.shape
    parts = image.reshape(n, x // 2, 2, y // 2, 2, z // 2, 2)
    return parts.permute(0, 2, 4, 6, 1, 3, 5).reshape(n, 8, x // 2, y // 2, z // 2)


def unfold_voxels(channels):
    """(N, 8 C, X, Y, Z) -> (N, C, 2 X, 2 Y, 2 Z); channel (4 dx + 2 dy + dz) C + c."""
    n, c, x, y, z = channels.shape
    parts = channels.reshape(n, 2, 2, 2, c // 8, x, y, z)
    return parts.permute(0, 4, 5, 1, 6, 2, 7, 3).reshape(n, c // 8, 2 * x, 2 * y, 2 * z)


class Block(nn.Module):
    """Convolution 3 x 3 x 3, instance normalisation, leaky rectifier."""

    def __init__(self, inputs, outputs):
        super().__init__()
        self.convolution = nn.Conv3d(inputs, outputs, 3, padding=1, bias=False)
        self.norm = nn.InstanceNorm3d(outputs, affine=True)

    def forward(self, x):
        return functional.leaky_relu(self.norm(self.convolution(x)), SLOPE)


class Mix(nn.Conv3d):
    """Convolution 1 x 1 x 1 as a product of matrices: the convolution of some processors takes ten times as long."""

    def __init__(self, inputs, outputs):
        super().__init__(inputs, outputs, 1)

    def forward(self, x):
        mixed = torch.matmul(self.weight.flatten(1), x.flatten(2)) + self.bias[:, None]
        return mixed.reshape(x.shape[0], -1, *x.shape[2:])


class BrainPrior(nn.Module):
    """Image (N, 1, 48, 56, 48) -> scores of the four classes on the same grid."""

    def __init__(self):
        super().__init__()
        inputs = (8,) + CHANNELS[:-1]
        self.down = nn.ModuleList(nn.Sequential(Block(i, o), Block(o, o)) for i, o in zip(inputs, CHANNELS))
        below = list(zip(CHANNELS[1:], CHANNELS[:-1]))
        self.narrow = nn.ModuleList(Mix(b, o) for b, o in below)
        self.up = nn.ModuleList(nn.Sequential(Block(o, o), Block(o, o)) for _, o in below)
        self.head = Mix(CHANNELS[0], 8 * CLASSES)

    def forward(self, image):
        x, kept = fold_voxels(image), []
        for level, block in enumerate(self.down):
            x = block(functional.max_pool3d(x, 2) if level else x)
            kept.append(x)
        for level in reversed(range(len(self.up))):
            x = functional.interpolate(self.narrow[level](x), scale_factor=2, mode='nearest')
            x = self.up[level](x + kept[level])
        return unfold_voxels(self.head(x))
