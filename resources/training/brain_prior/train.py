"""Trains the brain prior from label maps: python3 train.py --labels DIR --fold 0 -o weights.fnbp (README beside)."""
import argparse
import copy
import json
import os
import time

import numpy
import torch
from torch.nn import functional
from torch.utils.data import DataLoader, IterableDataset

import heads
import synthesis
from network import BrainPrior
from weights_file import write_weights

T1_SHARE = 0.5
BATCH = 2
RATE, WARM_UP, LAST_RATE = 2e-3, 50, 0.02  # Adam's rate, steps until it is reached, share of it at the end
AVERAGE = 0.995  # of the weights that are kept
VALIDATION_PER_HEAD = 4


class Samples(IterableDataset):
    """Pairs without end; sample i of a seed is the same whatever the number of workers."""

    def __init__(self, anatomy, statistics, seed, start):
        self.anatomy, self.statistics, self.seed, self.start = anatomy, statistics, seed, start

    def __iter__(self):
        worker = torch.utils.data.get_worker_info()
        torch.set_num_threads(1)
        index, stride = (self.start + worker.id, worker.num_workers) if worker else (self.start, 1)
        while True:
            rng = numpy.random.default_rng((self.seed, index))
            head = self.anatomy[int(rng.integers(len(self.anatomy)))]
            yield synthesis.sample(rng, head, self.statistics, rng.random() < T1_SHARE)
            index += stride


def loss_of(scores, shares):
    """Cross entropy over the four classes plus 1 - Dice of the brain."""
    logs = functional.log_softmax(scores, 1)
    entropy = -(shares * logs).sum(1).mean()
    found, true = logs[:, heads.BRAIN].exp(), shares[:, heads.BRAIN]
    both = (found * true).sum((1, 2, 3))
    dice = (2 * both + 1) / (found.square().sum((1, 2, 3)) + true.square().sum((1, 2, 3)) + 1)
    return entropy + (1 - dice).mean()


def dice_of(network, image, shares):
    with torch.no_grad():
        found = torch.softmax(network(image[None]), 1)[0, heads.BRAIN] > 0.5
    true = shares[heads.BRAIN] > 0.5
    return float(2 * (found & true).sum() / (found.sum() + true.sum()).clamp(1))


def validation_set(anatomy, statistics):
    """Half T1, half any contrast, the same for every run."""
    return [(head.name, k % 2 == 0, synthesis.sample(numpy.random.default_rng((977, h, k)), head, statistics, k % 2 == 0))
            for h, head in enumerate(anatomy) for k in range(VALIDATION_PER_HEAD)]


def validate(network, validation):
    """Dice of each sample, T1 and any contrast apart: median and minimum."""
    network.eval()
    scores = {True: [], False: []}
    for _, is_t1, (image, shares) in validation:
        scores[is_t1].append(dice_of(network, image, shares))
    return {('t1' if k else 'any'): (float(numpy.median(v)), min(v)) for k, v in scores.items() if v}


def rate_at(step, steps):
    if step < WARM_UP:
        return RATE * (step + 1) / WARM_UP
    return RATE * (LAST_RATE + (1 - LAST_RATE) * max(0.0, 1 - (step - WARM_UP) / max(1, steps - WARM_UP)))


def keep_average(average, network):
    for kept, new in zip(average.state_dict().values(), network.state_dict().values()):
        kept.mul_(AVERAGE).add_(new, alpha=1 - AVERAGE)


class Run:
    """Network, its running average, optimiser and step; saved whole, so that a stopped training goes on."""

    def __init__(self, arguments):
        torch.manual_seed(arguments.seed)
        self.network, self.step, self.seconds = BrainPrior(), 0, 0.0
        self.average = copy.deepcopy(self.network)
        self.optimiser = torch.optim.Adam(self.network.parameters(), lr=RATE)
        self.checkpoint = arguments.output + '.checkpoint'
        if os.path.exists(self.checkpoint):
            state = torch.load(self.checkpoint)
            self.network.load_state_dict(state['network'])
            self.average.load_state_dict(state['average'])
            self.optimiser.load_state_dict(state['optimiser'])
            self.step, self.seconds = state['step'], state['seconds']

    def save(self):
        state = dict(network=self.network.state_dict(), average=self.average.state_dict(),
                     optimiser=self.optimiser.state_dict(), step=self.step, seconds=self.seconds)
        torch.save(state, self.checkpoint + '.new')
        os.replace(self.checkpoint + '.new', self.checkpoint)

    def learn(self, image, shares, steps):
        for group in self.optimiser.param_groups:
            group['lr'] = rate_at(self.step, steps)
        self.network.train()
        loss = loss_of(self.network(image), shares)
        self.optimiser.zero_grad()
        loss.backward()
        torch.nn.utils.clip_grad_norm_(self.network.parameters(), 1.0)
        self.optimiser.step()
        self.step += 1
        # At first the average follows the weights, as it has nothing worth keeping.
        if self.step < 100:
            self.average.load_state_dict(self.network.state_dict())
        else:
            keep_average(self.average, self.network)
        return float(loss)


def arguments_of():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--labels', required=True, help='folder of the label maps')
    parser.add_argument('--fold', type=int, choices=range(4), help='leave every fourth head out, from this one on; absent: train on all')
    parser.add_argument('--steps', type=int, default=6000, help='of two heads each; the rate falls to the last one')
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--workers', type=int, default=1, help='processes that make heads')
    parser.add_argument('--threads', type=int, default=2)
    parser.add_argument('--every', type=int, default=100, help='steps between checkpoints and scores')
    parser.add_argument('-o', '--output', required=True, help='weights file; a checkpoint beside it goes on where it stopped')
    return parser.parse_args()


def report(run, arguments, losses, validation, out):
    scores = validate(run.average, validation)
    line = dict(step=run.step, heads=BATCH * run.step, hours=round(run.seconds / 3600, 3),
                loss=round(float(numpy.mean(losses)), 4), left_out=scores)
    print(json.dumps(line), flush=True)
    with open(arguments.output + '.log', 'a', encoding='utf-8') as log:
        log.write(json.dumps(line) + '\n')
    run.save()
    write_weights(run.average, out)


def main():
    arguments = arguments_of()
    torch.set_num_threads(arguments.threads)
    statistics = heads.read_statistics(arguments.labels)
    names = heads.list_heads(arguments.labels)
    left_out = heads.fold_of(names, arguments.fold)
    prepared = {n: heads.prepared_head(arguments.labels, n, statistics, arguments.output + '.heads') for n in names}
    anatomy = [prepared[n] for n in names if n not in left_out]
    validation = validation_set([prepared[n] for n in left_out], statistics)
    run = Run(arguments)
    samples = Samples(anatomy, statistics, arguments.seed, BATCH * run.step)
    losses, began = [], time.monotonic()
    for image, shares in DataLoader(samples, batch_size=BATCH, num_workers=arguments.workers):
        losses.append(run.learn(image, shares, arguments.steps))
        now = time.monotonic()
        run.seconds, began = run.seconds + now - began, now
        if run.step % arguments.every == 0 or run.step >= arguments.steps:
            report(run, arguments, losses, validation, arguments.output)
            losses = []
        if run.step >= arguments.steps:
            return


if __name__ == '__main__':
    main()
