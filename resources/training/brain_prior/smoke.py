"""Trains on balls for a few steps, stops and goes on, to see that every part runs: python3 smoke.py DIR (README beside).
DIR/weights.fnbp and DIR/expected.h (what torch gives with these weights) are for the C++ test."""
import os
import subprocess
import sys

import nibabel
import numpy

HERE = os.path.dirname(os.path.abspath(__file__))
SIZE, HEADS = 128, 4  # voxels of 1 mm along each axis
# Each radius in voxels, label inside it, name, mean and spread of its intensity; the later ones lie within.
SHELLS = ((60, 509, 'soft tissue', 70, 20), (52, 515, 'bone', 30, 10), (47, 24, 'fluid', 45, 15),
          (44, 3, 'cortex', 96, 12), (36, 2, 'white matter', 160, 12))
STEPS = 2  # of each of the two runs


def write_heads(folder):
    """Balls of shells, each a little longer than the last, and the table of their intensities."""
    os.makedirs(folder, exist_ok=True)
    axes = numpy.meshgrid(*[numpy.arange(SIZE) - SIZE / 2] * 3, indexing='ij')
    for head in range(HEADS):
        longer = 1 - 0.03 * head
        radius = numpy.sqrt(axes[0] ** 2 + (longer * axes[1]) ** 2 + axes[2] ** 2) / longer
        labels = numpy.zeros(radius.shape, numpy.int16)
        for shell in SHELLS:
            labels[radius < shell[0]] = shell[1]
        nibabel.save(nibabel.Nifti1Image(labels, numpy.eye(4)), os.path.join(folder, 'ball_%d.nii.gz' % head))
    with open(os.path.join(folder, 't1_intensities.csv'), 'w', encoding='utf-8') as table:
        table.write('label,name,class,mean_of_means,sd_of_means,mean_of_sds,sd_of_sds\n0,background,0,7,2,5,2\n')
        for row, (_, label, name, mean, spread) in enumerate(SHELLS):
            table.write('%d,%s,%d,%g,5,%g,2\n' % (label, name, row + 1, mean, spread))


def run(*arguments):
    """A script of this folder."""
    command = [sys.executable, os.path.join(HERE, arguments[0])] + list(arguments[1:])
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding='utf-8', check=False)


def python(*arguments):
    """What a script of this folder prints; it must succeed."""
    ran = run(*arguments)
    if ran.returncode:
        sys.exit('%s: %s' % (' '.join(arguments), ran.stderr))
    return ran.stdout


def see_starts(labels, weights):
    """A fold goes on from another training, unless that one knows a head which the fold leaves out."""
    start, other = weights + '.start', weights + '.other'
    fold = ('train.py', '--labels', labels, '--fold', '1', '--steps', '1', '-o', other, '--start')
    ran = run(*fold, weights + '.checkpoint')
    if not ran.returncode or 'has learned from ball_1' not in ran.stderr or os.path.exists(other):
        sys.exit('a start that knows the head left out was taken: %s' % ran.stderr)
    python('train.py', '--labels', labels, '--only', 'ball_2', '--steps', '1', '-o', start)
    print(python(*fold, start + '.checkpoint'), end='')


def main():
    if len(sys.argv) != 2:
        sys.exit('give one folder: python3 smoke.py DIR')
    labels, weights = os.path.join(sys.argv[1], 'labels'), os.path.join(sys.argv[1], 'weights.fnbp')
    write_heads(labels)
    for steps in (STEPS, 2 * STEPS):
        print(python('train.py', '--labels', labels, '--fold', '0', '--steps', str(steps), '-o', weights), end='')
    with open(os.path.join(sys.argv[1], 'expected.h'), 'w', encoding='utf-8') as file:
        file.write(python('expected.py', weights + '.checkpoint'))
    see_starts(labels, weights)
    print('trained for %d steps, stopped once: %s' % (2 * STEPS, weights))


if __name__ == '__main__':
    main()
