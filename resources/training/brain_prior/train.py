"""Trains the brain prior from label maps: python3 train.py --labels DIR --fold 0 -o weights.fnbp (README beside)."""
import argparse
import copy
import json
import os
import threading
import time

os.environ.setdefault('OPENBLAS_NUM_THREADS', '1')  # a process each has a thread; read when numpy is loaded
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
AVERAGE = 0.995  # of the weights that are kept
VALIDATION_PER_HEAD = 4
LONGEST_STEP_S = 600


class Recipe:
    """Heads to learn from, their intensities, and the seed."""

    def __init__(self, anatomy, statistics, seed):
        self.anatomy, self.statistics, self.seed = anatomy, statistics, seed

    def sample(self, index):
        """Sample `index` is the same whatever the number of processes: image and shares, a batch of one."""
        rng = numpy.random.default_rng((self.seed, index))
        head = self.anatomy[int(rng.integers(len(self.anatomy)))]
        image, shares = synthesis.sample(rng, head, self.statistics, rng.random() < T1_SHARE)
        return image[None], shares[None]


class OneByOne:
    """The gradient on a GPU, of heads that are made there too. The interface of Workers."""

    def __init__(self, recipe):
        self.recipe = recipe

    def gradient(self, network, first):
        made = [self.recipe.sample(first + rank) for rank in range(BATCH)]
        image, shares = (torch.cat(parts) for parts in zip(*made))
        with torch.autocast(device.chosen().type, torch.bfloat16):
            scores = network(image)
        loss = loss_of(scores.float(), shares)
        network.zero_grad()
        loss.backward()
        return torch.cat([p.grad.reshape(-1) for p in network.parameters()]), loss.detach()


class Workers:
    """Processes that each make a head and its gradient; weights and gradients lie in shared memory."""

    def __init__(self, network, recipe):
        self.weights = torch.nn.utils.parameters_to_vector(network.parameters()).detach().clone().share_memory_()
        self.gradients = torch.zeros(BATCH, len(self.weights)).share_memory_()
        self.losses, self.first = torch.zeros(BATCH).share_memory_(), torch.zeros(1, dtype=torch.int64).share_memory_()
        self.barrier = multiprocessing.Barrier(BATCH + 1)
        for rank in range(BATCH):
            multiprocessing.Process(target=self.work, args=(rank, recipe), daemon=True).start()

    def work(self, rank, recipe):
        torch.set_num_threads(1)
        device.keep_memory()
        network, half = BrainPrior().train(), device.halves_quickly()
        while True:
            self.barrier.wait()
            image, shares = recipe.sample(int(self.first) + rank)
            torch.nn.utils.vector_to_parameters(self.weights.clone(), network.parameters())
            # Half precision takes half the time; weights, loss and their steps stay in single.
            with torch.autocast('cpu', torch.bfloat16, enabled=half):
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
        try:
            self.barrier.wait(LONGEST_STEP_S)
            self.barrier.wait(LONGEST_STEP_S)
        except threading.BrokenBarrierError:
            raise SystemExit('a process that makes heads has ended: start again, it goes on from the checkpoint') from None
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


def rate_at(step, done, full):
    """Adam's rate; `done`: share of the training that is over; `full`: share of full rate, then a falling line."""
    if step < WARM_UP:
        return RATE * (step + 1) / WARM_UP
    return RATE * (LAST_RATE + (1 - LAST_RATE) * min(1.0, max(0.0, (1 - done) / max(1e-9, 1 - full))))


def keep_average(average, network):
    for kept, new in zip(average.state_dict().values(), network.state_dict().values()):
        kept.mul_(AVERAGE).add_(new, alpha=1 - AVERAGE)


class Run:
    """Network, its running average, optimiser and step; saved whole, so that a stopped training goes on."""

    def __init__(self, arguments, learned, left_out):
        torch.manual_seed(arguments.seed)
        self.network, self.step, self.seconds = BrainPrior().to(device.chosen()), 0, 0.0
        self.average, self.learned, self.full_rate = copy.deepcopy(self.network), set(learned), arguments.full_rate
        self.optimiser = torch.optim.Adam(self.network.parameters(), lr=RATE)
        self.checkpoint = arguments.output + '.checkpoint'
        if os.path.exists(self.checkpoint):
            state = self.take(self.checkpoint, left_out)
            self.step, self.seconds = state['step'], state['seconds']
        elif arguments.start:
            self.take(arguments.start, left_out)
        self.is_continued = self.step > 0 or bool(arguments.start)

    def take(self, path, left_out):
        """Weights and optimiser of a checkpoint. Exits where it has learned from a head that is left out."""
        state = torch.load(path, map_location='cpu')  # what belongs on a GPU is sent there below
        if 'learned' not in state:
            raise SystemExit(f'{path}: does not say which heads it has learned from (an older checkpoint): train anew')
        seen = sorted(set(state['learned']) & set(left_out))
        if seen:
            raise SystemExit(f'{path}: has learned from {", ".join(seen)}, left out by this fold: take another start')
        self.network.load_state_dict(state['network'])
        self.average.load_state_dict(state['average'])
        self.optimiser.load_state_dict(state['optimiser'])
        self.learned |= set(state['learned'])
        return state

    def save(self):
        state = dict(network=self.network.state_dict(), average=self.average.state_dict(), learned=sorted(self.learned),
                     optimiser=self.optimiser.state_dict(), step=self.step, seconds=self.seconds)
        torch.save(state, self.checkpoint + '.new')
        os.replace(self.checkpoint + '.new', self.checkpoint)

    def learn(self, workers, done):
        for group in self.optimiser.param_groups:
            group['lr'] = rate_at(self.step, done, self.full_rate)
        gradient, loss = workers.gradient(self.network, BATCH * self.step)
        at = 0
        for parameter in self.network.parameters():
            parameter.grad = gradient[at:at + parameter.numel()].reshape(parameter.shape).clone()
            at += parameter.numel()
        torch.nn.utils.clip_grad_norm_(self.network.parameters(), 1.0)
        self.optimiser.step()
        self.step += 1
        # At first the average follows the weights, as it has nothing worth keeping.
        if self.step < 100 and not self.is_continued:
            self.average.load_state_dict(self.network.state_dict())
        else:
            keep_average(self.average, self.network)
        return loss


def arguments_of():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--labels', required=True, help='folder of the label maps')
    parser.add_argument('--fold', type=int, choices=range(4),
                        help='leave every fourth head out, from this one on; absent: train on all')
    parser.add_argument('--only', help='names of the heads to learn from, as 02,07: a start that several folds share')
    parser.add_argument('--start', help='checkpoint of another training to go on from; it must not know a left-out head')
    parser.add_argument('--full-rate', type=float, default=0.3, help='share of the training before the rate falls')
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
    only = arguments.only.split(',') if arguments.only else names
    if unknown := set(only) - set(names):
        raise SystemExit(f'--only {", ".join(sorted(unknown))}: the heads are {", ".join(names)}')
    learned = [n for n in only if n not in left_out]
    if not learned:
        raise SystemExit(f'--only {arguments.only}: fold {arguments.fold} leaves all of them out')
    validation = validation_set([prepared[n] for n in left_out], statistics)
    run = Run(arguments, learned, left_out)
    recipe = Recipe([prepared[n] for n in learned], statistics, arguments.seed)
    workers = OneByOne(recipe) if arguments.device == 'cuda' else Workers(run.network, recipe)
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
