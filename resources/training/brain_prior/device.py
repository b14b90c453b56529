"""Where the tensors are made: the processor, or a CUDA GPU after use('cuda')."""
import ctypes

import numpy
import torch

_CHOSEN = [torch.device('cpu')]
_KEPT = {}  # arrays that were sent once: id -> (array, tensor)


def use(name):
    """'cpu' or 'cuda'. Before the first tensor is made."""
    if name == 'cuda' and not torch.cuda.is_available():
        raise SystemExit('no CUDA GPU is seen by torch: take --device cpu')
    _CHOSEN[0] = torch.device(name)
    torch.backends.cudnn.benchmark = True  # shapes repeat: the quickest convolution of each is looked for once


def chosen():
    return _CHOSEN[0]


def halves_quickly():
    """True where this processor has the half precision that torch uses; elsewhere that takes ten times as long."""
    with open('/proc/cpuinfo', encoding='utf-8') as file:
        flags = set(file.read().split())
    return {'avx512bw', 'avx512vl', 'avx512dq'} <= flags


def keep_memory():
    """glibc keeps what a step frees: giving back and asking anew takes a third of the step."""
    trim_threshold, mmap_threshold = -1, -3  # of malloc.h
    libc = ctypes.CDLL(None)
    libc.mallopt(mmap_threshold, 2 ** 31 - 1)
    libc.mallopt(trim_threshold, 2 ** 31 - 1)


def on(array):
    """A numpy array as a tensor."""
    return torch.from_numpy(array).to(chosen())


def kept(array):
    """As on(), sent once: for arrays that stay, such as a head."""
    if id(array) not in _KEPT:
        _KEPT[id(array)] = (array, on(array))
    return _KEPT[id(array)][1]


def normal(rng, size):
    """Normal values; a GPU draws its own, from a seed that rng draws."""
    if chosen().type == 'cpu':
        return torch.from_numpy(rng.standard_normal(size, dtype=numpy.float32))
    generator = torch.Generator(chosen()).manual_seed(int(rng.integers(2 ** 62)))
    return torch.randn(size, generator=generator, device=chosen())


def value(number):
    return torch.full((), float(number), device=chosen())


def steps(count):
    """0, 1, .. count - 1."""
    return torch.arange(count, dtype=torch.float32, device=chosen())


def line(count):
    """-1 .. 1."""
    return torch.linspace(-1, 1, count, device=chosen())
