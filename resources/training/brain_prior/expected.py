"""Prints what torch gives for a fixed pattern, as the C++ test holds it (testing/unit/segmentation/prior_expected.h):
python3 expected.py weights.fnbp.checkpoint > prior_expected.h"""
import sys

import torch

from network import SIZE, BrainPrior

PLACES = ((0, 0, 0), (24, 28, 24), (25, 28, 24), (24, 29, 24), (24, 28, 25), (47, 55, 47), (10, 40, 33), (37, 5, 12))


def main():
    network = BrainPrior()
    network.load_state_dict(torch.load(sys.argv[1], map_location='cpu')['average'])
    for parameter in network.parameters():
        parameter.data = parameter.data.half().float()  # as the weights file holds them
    i, j, k = [torch.arange(n, dtype=torch.float64) for n in SIZE]
    image = torch.sin(0.37 * i)[:, None, None] * torch.sin(0.23 * j + 1)[:, None] * torch.sin(0.31 * k + 2)
    with torch.no_grad():
        shares = torch.softmax(network((0.5 + 0.5 * image).float()[None, None]), 1)[0]
    print('#pragma once')
    print('// What torch gives for the test\'s pattern: made by resources/training/brain_prior/expected.py.\n')
    print('namespace facenav::segmentation {\n')
    print('struct ExpectedShares {\n  int i, j, k;\n  float share[4];\n};')
    print('constexpr ExpectedShares kExpectedByTorch[] = {')
    for p in PLACES:
        print('    {%d, %d, %d, {%s}},' % (p + (', '.join('%.6ff' % float(v) for v in shares[(slice(None),) + p]),)))
    print('};\n\n}  // namespace facenav::segmentation')


if __name__ == '__main__':
    main()
