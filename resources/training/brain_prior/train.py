"""Trains the brain prior from label maps: python3 train.py --labels DIR --fold 0 -o weights.fnbp (README beside)."""
import argparse
import copy
import json
import os
import time

import numpy
import torch
from torch import multiprocessing
from torch.nn import functional

import device
import heads
import synthesis
from network import BrainPrior
from weights_file import write_weights

T1_SHARE = 0.5
BATCH = 2  # heads a step, a process each
RATE, WARM_UP, LAST_RATE = 2e-3, 50, 0.01  # Adam's rate, steps until it is reached, share of it at the end
FULL_RATE_SHARE = 0.3  # of the training, before the rate falls
AVERAGE = 0.995  # of the weights that are kept
VALIDATION_PER_HEAD = 4


def sample_of(anatomy, statistics, seed, index):
    """Sample `index` of a seed is the same whatever the number of processes: image and shares, a batch of one."""
    rng = numpy.random.default_rng((seed, index))
    head = anatomy[int(rng.integers(len(anatomy)))]
    image, shares = synthesis.sample(rng, head, statistics, rng.random() < T1_SHARE)
    return image[None], shares[None]


class OneByOne:
    """The gradient on a GPU, of heads that are made there too. The interface of Workers."""

    def __init__(self, anatomy, statistics, seed):
        self.heads = anatomy, statistics, seed

    def gradient(self, network, first):
        made = [sample_of(*self.heads, first + rank) for rank in range(BATCH)]
        image, shares = (torch.cat(parts) for parts in zip(*made))
        with torch.autocast(device.chosen().type, torch.bfloat16):
            scores = network(image)
        loss = loss_of(scores.float(), shares)
        network.zero_grad()
        loss.backward()
        return torch.cat([p.grad.reshape(-1) for p in network.parameters()]), loss.detach()


class Workers:
    """Processes that each make a head and its gradient; weights and gradients lie in shared memory."""

    def __init__(self, network, anatomy, statistics, seed):
        self.weights = torch.nn.utils.parameters_to_vector(network.parameters()).detach().clone().share_memory_()
        self.gradients = torch.zeros(BATCH, len(self.weights)).share_memory_()
        self.losses, self.first = torch.zeros(BATCH).share_memory_(), torch.zeros(1, dtype=torch.int64).share_memory_()
        self.barrier = multiprocessing.Barrier(BATCH + 1)
        for rank in range(BATCH):
            multiprocessing.Process(target=self.work, args=(rank, anatomy, statistics, seed), daemon=True).start()

    def work(self, rank, anatomy, statistics, seed):
        torch.set_num_threads(1)
        network = BrainPrior().train()
        while True:
            self.barrier.wait()
            image, shares = sample_of(anatomy, statistics, seed, int(self.first) + rank)
            torch.nn.utils.vector_to_parameters(self.weights.clone(), network.parameters())
            # Half precision takes half the time; weights, loss and their steps stay in single.
            with torch.autocast('cpu', torch.bfloat16):
                scores = network(image)
            loss = loss_of(scores.float(), shares)
            network.zero_grad()
            loss.backward()
            self.gradients[rank] = torch.cat([p.grad.reshape(-1) for p in network.parameters()])
            self.losses[rank] = float(loss)
            self.barrier.wait()

    def gradient(self, network, first):
        """Of samples first, first + 1, .., their mean; and the mean of the losses."""
        self.weights.copy_(torch.nn.utils.parameters_to_vector(network.parameters()).detach())
        self.first[0] = first
        self.barrier.wait()
        self.barrier.wait()
        return self.gradients.mean(0), self.losses.mean()


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


def rate_at(step, done):
    """Adam's rate; `done`: share of the training that is over. Full for a third, then a falling line."""
    if step < WARM_UP:
        return RATE * (step + 1) / WARM_UP
    return RATE * (LAST_RATE + (1 - LAST_RATE) * min(1.0, max(0.0, (1 - done) / (1 - FULL_RATE_SHARE))))


def keep_average(average, network):
    for kept, new in zip(average.state_dict().values(), network.state_dict().values()):
        kept.mul_(AVERAGE).add_(new, alpha=1 - AVERAGE)


class Run:
    """Network, its running average, optimiser and step; saved whole, so that a stopped training goes on."""

    def __init__(self, arguments):
        torch.manual_seed(arguments.seed)
        self.network, self.step, self.seconds = BrainPrior().to(device.chosen()), 0, 0.0
        self.average = copy.deepcopy(self.network)
        self.optimiser = torch.optim.Adam(self.network.parameters(), lr=RATE)
        self.checkpoint = arguments.output + '.checkpoint'
        if os.path.exists(self.checkpoint):
            state = torch.load(self.checkpoint, map_location=device.chosen())
            self.network.load_state_dict(state['network'])
            self.average.load_state_dict(state['average'])
            self.optimiser.load_state_dict(state['optimiser'])
            self.step, self.seconds = state['step'], state['seconds']

    def save(self):
        state = dict(network=self.network.state_dict(), average=self.average.state_dict(),
                     optimiser=self.optimiser.state_dict(), step=self.step, seconds=self.seconds)
        torch.save(state, self.checkpoint + '.new')
        os.replace(self.checkpoint + '.new', self.checkpoint)

    def learn(self, workers, done):
        for group in self.optimiser.param_groups:
            group['lr'] = rate_at(self.step, done)
        gradient, loss = workers.gradient(self.network, BATCH * self.step)
        at = 0
        for parameter in self.network.parameters():
            parameter.grad = gradient[at:at + parameter.numel()].reshape(parameter.shape).clone()
            at += parameter.numel()
        torch.nn.utils.clip_grad_norm_(self.network.parameters(), 1.0)
        self.optimiser.step()
        self.step += 1
        # At first the average follows the weights, as it has nothing worth keeping.
        if self.step < 100:
            self.average.load_state_dict(self.network.state_dict())
        else:
            keep_average(self.average, self.network)
        return loss


def arguments_of():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--labels', required=True, help='folder of the label maps')
    parser.add_argument('--fold', type=int, choices=range(4),
                        help='leave every fourth head out, from this one on; absent: train on all')
    parser.add_argument('--heads', help='folder of the prepared heads; default: OUTPUT.heads')
    parser.add_argument('--hours', type=float, default=2, help='how long to train; the rate falls until then')
    parser.add_argument('--steps', type=int, help='train so many steps, however long they take')
    parser.add_argument('--device', choices=('cpu', 'cuda'), default='cpu', help='cuda: heads and network on the GPU')
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--every', type=int, default=250, help='steps between checkpoints and scores')
    parser.add_argument('-o', '--output', required=True, help='weights file; a checkpoint beside it goes on where it stopped')
    return parser.parse_args()


def share_done(run, arguments):
    """Of the training, 0 to 1: by steps where their number is given, else by the time spent."""
    return run.step / arguments.steps if arguments.steps else run.seconds / (3600 * arguments.hours)


def report(run, arguments, losses, validation, out):
    scores = validate(run.average, validation)
    line = dict(step=run.step, heads=BATCH * run.step, hours=round(run.seconds / 3600, 3),
                loss=round(float(torch.stack(losses).mean()), 4), left_out=scores)
    print(json.dumps(line), flush=True)
    with open(arguments.output + '.log', 'a', encoding='utf-8') as log:
        log.write(json.dumps(line) + '\n')
    run.save()
    write_weights(run.average, out)


def main():
    arguments = arguments_of()
    torch.set_num_threads(1)
    device.use(arguments.device)
    statistics = heads.read_statistics(arguments.labels)
    names = heads.list_heads(arguments.labels)
    left_out = heads.fold_of(names, arguments.fold)
    cache = arguments.heads or arguments.output + '.heads'
    prepared = {n: heads.prepared_head(arguments.labels, n, statistics, cache) for n in names}
    anatomy = [prepared[n] for n in names if n not in left_out]
    validation = validation_set([prepared[n] for n in left_out], statistics)
    run = Run(arguments)
    heads_of = anatomy, statistics, arguments.seed
    workers = OneByOne(*heads_of) if arguments.device == 'cuda' else Workers(run.network, *heads_of)
    losses, began, over = [], time.monotonic(), share_done(run, arguments) >= 1
    while not over:
        losses.append(run.learn(workers, share_done(run, arguments)))
        now = time.monotonic()
        run.seconds, began = run.seconds + now - began, now
        over = share_done(run, arguments) >= 1
        if run.step % arguments.every == 0 or over:
            report(run, arguments, losses, validation, arguments.output)
            losses = []


if __name__ == '__main__':
    main()
