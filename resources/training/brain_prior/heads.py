"""The labelled heads as arrays: compact labels, the brain as the prior learns it, statistics of T1 intensity."""
import glob
import itertools
import os

import numpy

# The brain with closed tissue is all labels but these and those above 500 (README of the label maps).
NOT_BRAIN = (0, 24, 30, 62, 72, 85, 136, 137, 163, 164)
AIR, BRAIN, FLUID_CLASS, OTHER = range(4)  # fluid: all inside the skull that is no tissue, vessels too
CLOSING_VOXELS = 2
MARGIN_MM = 12


class Head:
    """One head, RAS, 1 mm, cut to its box. `labels`: uint8 rows of the statistics; `targets`: uint8, the four classes."""

    def __init__(self, name, labels, targets):
        self.name, self.labels, self.targets = name, labels, targets
        self.centre = numpy.argwhere(targets == BRAIN).mean(0).astype(numpy.float32)


def dilated(mask, offsets):
    """True where any voxel at the offsets is. Wraps around: the rim must be all true or all false."""
    out = numpy.zeros_like(mask)
    for offset in offsets:
        out |= numpy.roll(mask, offset, (0, 1, 2))
    return out


def closed_brain(labels):
    """Tissue with sulci closed by a ball of two voxels and holes filled: bool, same shape."""
    from scipy import ndimage  # a machine that is given prepared heads needs neither scipy nor nibabel
    tissue = (labels < 500) & ~numpy.isin(labels, NOT_BRAIN)
    r = CLOSING_VOXELS
    offsets = [o for o in itertools.product(range(-r, r + 1), repeat=3) if sum(v * v for v in o) <= r * r]
    places = numpy.argwhere(tissue)
    low, high = places.min(0), places.max(0) + 1
    box = tuple(slice(a, b) for a, b in zip(low, high))
    padded = numpy.pad(tissue[box], 2 * r)
    closed = ~dilated(~dilated(padded, offsets), offsets)
    background, _ = ndimage.label(~closed)  # holes do not reach the corner
    closed = background != background[0, 0, 0]
    whole = numpy.zeros_like(tissue)
    whole[box] = closed[2 * r:-2 * r, 2 * r:-2 * r, 2 * r:-2 * r]
    return whole


def read_statistics(folder):
    """label -> (row index, tissue class, mean of means, its sd, mean of sds, its sd), intensities 0..255."""
    with open(os.path.join(folder, 't1_intensities.csv'), encoding='utf-8') as file:
        rows = [line.strip().split(',') for line in file.readlines()[1:] if line.strip()]
    # Names hold commas: the numbers are counted from the end of the line.
    return {int(r[0]): (i, int(r[-5])) + tuple(float(v) for v in r[-4:]) for i, r in enumerate(rows)}


def list_heads(folder):
    """Names of all heads, sorted."""
    return sorted(os.path.basename(p)[:-7] for p in glob.glob(os.path.join(folder, '*.nii.gz')))


def fold_of(names, fold):
    """The four names that fold 0..3 leaves out; none for fold None."""
    return [] if fold is None else names[fold::4]


def nearest_known(label, statistics):
    """Labels without statistics stand in for a like tissue: cortex in the brain, soft tissue outside."""
    return label if label in statistics else 3 if label < 500 else 509


def prepared_head(folder, name, statistics, cache):
    """As read_head, kept in the folder `cache` for the next start."""
    path = os.path.join(cache, name + '.npz')
    if os.path.exists(path):
        kept = numpy.load(path)
        return Head(name, kept['labels'], kept['targets'])
    head = read_head(folder, name, statistics)
    os.makedirs(cache, exist_ok=True)
    numpy.savez_compressed(path + '.new.npz', labels=head.labels, targets=head.targets)
    os.replace(path + '.new.npz', path)
    return head


def read_head(folder, name, statistics):
    """Reads, turns to RAS and cuts one head."""
    import nibabel
    image = nibabel.as_closest_canonical(nibabel.load(os.path.join(folder, name + '.nii.gz')))
    labels = numpy.asarray(image.dataobj).astype(numpy.int32)
    places = numpy.argwhere(labels > 0)
    low = numpy.maximum(places.min(0) - MARGIN_MM, 0)
    high = numpy.minimum(places.max(0) + MARGIN_MM + 1, labels.shape)
    labels = labels[low[0]:high[0], low[1]:high[1], low[2]:high[2]]
    brain = closed_brain(labels)
    table = numpy.zeros(labels.max() + 1, numpy.uint8)
    targets = numpy.zeros(labels.max() + 1, numpy.uint8)
    for label in numpy.unique(labels):
        table[label] = statistics[nearest_known(int(label), statistics)][0]
        targets[label] = AIR if label == 0 else OTHER if label > 500 else FLUID_CLASS
    classes = targets[labels]
    classes[brain] = BRAIN
    return Head(name, table[labels], classes)
