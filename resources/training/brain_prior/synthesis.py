"""Heads with contrast, shape, field of view and faults drawn at random, from label maps (SynthSeg, Billot 2023;
SynthStrip, Hoopes 2022: the idea; ranges below are choices of ours, none fitted to a scan)."""
import math

import numpy
import torch
from torch.nn import functional

import device
from heads import AIR, BRAIN, FLUID_CLASS, OTHER
from network import SIZE, SPACING_MM

SHIFT_MM = 20          # of the window against the brain's centre, each axis
FAR_SHARE, FAR_SHIFT_MM = 0.2, 60  # the first look at a scan, before its brain's place is known
CHILD_SHARE = 0.15     # heads scaled down to a child's
EDGE_PERCENTILES = (0.02, 0.98)  # of the window: black and white of the network's input


def uniform(rng, low, high):
    return float(rng.uniform(low, high))


def smooth_noise(rng, knots, size=SIZE):
    """Normal values on a coarse lattice, trilinearly between them: (1, 1, *size)."""
    coarse = device.on(rng.standard_normal((1, 1) + tuple(knots)).astype(numpy.float32))
    return functional.interpolate(coarse, size=size, mode='trilinear', align_corners=True)


def turned(rng):
    """Rotation, scale and shear of a head: 3 x 3, window to head."""
    angles = numpy.clip(rng.normal(0, 9, 3), -30, 30) * math.pi / 180
    matrix = numpy.eye(3)
    for axis, angle in enumerate(angles):
        turn = numpy.eye(3)
        a, b = (axis + 1) % 3, (axis + 2) % 3
        turn[a, a] = turn[b, b] = math.cos(angle)
        turn[a, b], turn[b, a] = -math.sin(angle), math.sin(angle)
        matrix = matrix @ turn
    size = uniform(rng, 0.75, 0.9) if rng.random() < CHILD_SHARE else uniform(rng, 0.88, 1.15)
    scale = numpy.diag(1 / (size * rng.uniform(0.94, 1.06, 3)))
    shear = numpy.eye(3) + numpy.triu(rng.normal(0, 0.03, (3, 3)), 1)
    mirror = numpy.diag([-1.0 if rng.random() < 0.5 else 1.0, 1.0, 1.0])
    return matrix @ scale @ shear @ mirror


def deformed_places(rng, head):
    """Where each voxel of the window lies in the head's array (voxels of 1 mm): (3, *SIZE)."""
    axes = [(device.steps(n) - (n - 1) / 2) * SPACING_MM for n in SIZE]
    window = torch.stack(torch.meshgrid(*axes, indexing='ij')).reshape(3, -1)
    most = FAR_SHIFT_MM if rng.random() < FAR_SHARE else SHIFT_MM
    window = window + device.on(rng.uniform(-most, most, (3, 1)).astype(numpy.float32))
    places = device.on(turned(rng).astype(numpy.float32)) @ window
    places = (places + device.on(head.centre)[:, None]).reshape(3, *SIZE)
    for knots, most_mm in (((5, 6, 5), 5.0), ((10, 12, 10), 2.5)):
        amount = uniform(rng, 0, most_mm)
        places += amount * torch.cat([smooth_noise(rng, knots)[0] for _ in range(3)])
    return places


def gather(volumes, places):
    """Nearest voxel of each of the volumes of one shape; air outside."""
    index = torch.zeros(places.shape[1:], dtype=torch.int64, device=device.chosen())
    inside = torch.ones(places.shape[1:], dtype=torch.bool, device=device.chosen())
    for axis, n in enumerate(volumes[0].shape):
        at = places[axis].round().long()
        inside &= (at >= 0) & (at < n)
        index = index * n + at.clamp(0, n - 1)
    return [device.kept(volume).reshape(-1)[index] * inside for volume in volumes]


def draw_means(rng, statistics, is_t1):
    """Mean and spread of each row of the statistics, 0..255."""
    rows = sorted(statistics.values())
    count = max(r[1] for r in rows) + 1
    means, spreads = numpy.zeros(len(rows), numpy.float32), numpy.zeros(len(rows), numpy.float32)
    if is_t1:
        wide = uniform(rng, 0.8, 1.6)
        by_class = {r[1]: (rng.normal(r[2], wide * r[3]), max(1.0, rng.normal(r[4], r[5]))) for r in rows}
        spread_share = uniform(rng, 0.3, 1.0)  # of the published spread: much of it is anatomy, not noise
        for r in rows:
            means[r[0]], spreads[r[0]] = by_class[r[1]][0], spread_share * by_class[r[1]][1]
    else:
        drawn, spread = rng.uniform(0, 255, count), rng.uniform(0, 30, count)
        for r in rows:
            means[r[0]], spreads[r[0]] = drawn[r[1]] + rng.normal(0, 6), spread[r[1]]
        if rng.random() < 0.8:  # air is dark in most contrasts
            means[0], spreads[0] = uniform(rng, 0, 15), uniform(rng, 0, 8)
    return numpy.maximum(means, 0), spreads


def paint(rng, rows, statistics, is_t1):
    """Intensities of the tissues with their texture, mean of the places within each voxel: (*SIZE)."""
    means, spreads = draw_means(rng, statistics, is_t1)
    share = uniform(rng, 0, 1)
    # Of a texture from voxel to voxel little is left in the mean of a voxel of 4 mm.
    fine = 0.35 * device.normal(rng, SIZE)
    coarse = smooth_noise(rng, [int(s / uniform(rng, 2, 5)) for s in SIZE])[0, 0] * 1.5
    texture = math.sqrt(share) * fine + math.sqrt(1 - share) * coarse
    index = rows.long()
    return device.on(means)[index].mean(0) + device.on(spreads)[index].mean(0) * texture


def add_lesions(rng, image, is_brain):
    """Balls of another intensity in and about the brain."""
    if rng.random() > 0.2:
        return image
    for _ in range(int(rng.integers(1, 4))):
        places = torch.nonzero(is_brain)
        if not len(places):
            return image
        centre = places[int(rng.integers(len(places)))].float()
        axes = torch.meshgrid(*[device.steps(n) for n in SIZE], indexing='ij')
        distance = sum((a - c) ** 2 for a, c in zip(axes, centre))
        image = torch.where(distance < uniform(rng, 1, 4.5) ** 2, device.value(uniform(rng, 0, 255)), image)
    return image


def add_haze_and_pads(rng, image, air):
    """Outside the head: a faint halo, or pads of low intensity beside it."""
    if rng.random() > 0.25:
        return image
    halo = functional.avg_pool3d((1 - air)[None, None], 5, stride=1, padding=2)[0, 0]
    texture = (1 + 0.5 * smooth_noise(rng, (6, 7, 6))[0, 0]).clamp(min=0)
    return torch.where(air > 0.9, image + uniform(rng, 5, 50) * halo * texture, image)


def blur(image, sigmas):
    """Gaussian, sigma in voxels per axis."""
    x = image[None, None]
    for axis, sigma in enumerate(sigmas):
        if sigma < 0.15:
            continue
        half = max(1, int(math.ceil(2.5 * sigma)))
        kernel = torch.exp(-0.5 * ((device.steps(2 * half + 1) - half) / sigma) ** 2)
        shape, padding = [1, 1, 1, 1, 1], [0, 0, 0]
        shape[axis + 2], padding[axis] = 2 * half + 1, half
        x = functional.conv3d(x, (kernel / kernel.sum()).reshape(shape), padding=padding)
    return x[0, 0]


def scan_like(rng, image):
    """Sharpness, slice thickness, shading, ghost, noise."""
    sigmas = [uniform(rng, 0.1, 0.4)] * 3
    if rng.random() < 0.4:  # thick slices
        sigmas[int(rng.integers(3))] = uniform(rng, 0.4, 0.9)
    image = blur(image, sigmas).clamp(min=0)
    knots = [int(k) for k in rng.integers(2, 6, 3)]
    image = image * torch.exp(uniform(rng, 0, 0.35) * smooth_noise(rng, knots)[0, 0])
    if rng.random() < 0.25:  # a surface coil: bright towards one point
        axes = torch.meshgrid(*[device.line(n) for n in SIZE], indexing='ij')
        at = rng.uniform(-1.3, 1.3, 3)
        near = torch.exp(-sum((a - float(c)) ** 2 for a, c in zip(axes, at)) / uniform(rng, 0.3, 2))
        image = image * (1 + uniform(rng, 0.3, 3) * near)
    if rng.random() < 0.15:
        axis = int(rng.integers(3))
        image = image + uniform(rng, 0.02, 0.15) * torch.roll(image, int(uniform(rng, 0.3, 0.7) * SIZE[axis]), axis)
    noise = uniform(rng, 0, 12) * 10 ** uniform(rng, -1, 0.3)
    real = image + noise * device.normal(rng, SIZE)
    imaginary = noise * device.normal(rng, SIZE)
    return torch.sqrt(real ** 2 + imaginary ** 2)


def seen(rng, is_inside_skull):
    """Where the scan reaches and no face was taken off: bool (*SIZE)."""
    keep = torch.ones(SIZE, dtype=torch.bool, device=device.chosen())
    axes = torch.meshgrid(*[device.line(n) for n in SIZE], indexing='ij')
    if rng.random() < 0.25:  # face removed: below and in front of an oblique plane
        up, front = uniform(rng, -0.6, 0.05), uniform(rng, 0.3, 0.9)
        removed = (axes[2] - up) < uniform(rng, 0.2, 1.2) * (axes[1] - front)
        keep &= ~removed | is_inside_skull
    if rng.random() < 0.35:  # the neck is cut
        keep &= axes[2] > uniform(rng, -1, -0.45)
    if rng.random() < 0.15:  # narrow field of view, sides, back, front, top
        axis, side = int(rng.integers(3)), int(rng.integers(2))
        limit = uniform(rng, 0.6, 0.95)
        keep &= (axes[axis] < limit) if side else (axes[axis] > (-limit if axis < 2 else -1))
    return keep


def normalised(image, keep):
    """Black and white by percentiles of the window, clamped to -0.2 .. 2; zero where nothing was scanned."""
    values = torch.sort(torch.where(keep, image, device.value(0)).reshape(-1)).values
    low, high = (values[int(p * (len(values) - 1))] for p in EDGE_PERCENTILES)
    out = ((torch.where(keep, image, low) - low) / (high - low + 1e-6)).clamp(-0.2, 2)
    return out


def sample(rng, head, statistics, is_t1):
    """One training pair: image (1, *SIZE), target shares of the four classes (4, *SIZE)."""
    places = deformed_places(rng, head)
    # Four corners of a cube within each voxel of 4 mm: partial volume for a quarter of the work.
    corners = torch.tensor([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], dtype=torch.float32, device=device.chosen()).T
    within = places[:, None] + SPACING_MM / 4 * corners[:, :, None, None, None]
    rows, classes = gather((head.labels, head.targets), within)
    shares = torch.stack([(classes == c).float().mean(0) for c in (AIR, BRAIN, FLUID_CLASS, OTHER)])
    image = paint(rng, rows, statistics, is_t1)
    image = add_lesions(rng, image, shares[BRAIN] > 0.5)
    image = add_haze_and_pads(rng, image, shares[AIR])
    image = scan_like(rng, image)
    if rng.random() < 0.4:
        image = (image / 255) ** math.exp(uniform(rng, -0.35, 0.35))
    keep = seen(rng, shares[BRAIN] + shares[FLUID_CLASS] > 0)
    shares = torch.where(keep, shares, device.value(0))
    shares[AIR] += (~keep).float()
    return normalised(image, keep)[None], shares
