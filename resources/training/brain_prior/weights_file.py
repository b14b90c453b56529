"""The weights file, all little endian:
"FNBP", uint32 version 1, uint32 number of tensors, for each uint32 rank, rank x uint32 sizes; then all values in
half precision, tensor after tensor, last index fastest; then uint32 CRC-32 (zlib) of all that came before."""
import struct
import zlib

import numpy

MAGIC, VERSION = b'FNBP', 1


def ordered_tensors(network):
    """Down blocks level by level, then for each level from the coarsest up: narrow, up blocks; then the head."""
    def block(b):
        return [b.convolution.weight, b.norm.weight, b.norm.bias]

    tensors = [t for level in network.down for b in level for t in block(b)]
    for level in reversed(range(len(network.up))):
        tensors += [network.narrow[level].weight, network.narrow[level].bias]
        tensors += [t for b in network.up[level] for t in block(b)]
    return tensors + [network.head.weight, network.head.bias]


def write_weights(network, path):
    arrays = [t.detach().cpu().numpy() for t in ordered_tensors(network)]
    content = MAGIC + struct.pack('<II', VERSION, len(arrays))
    for a in arrays:
        content += struct.pack('<I', a.ndim) + struct.pack('<%dI' % a.ndim, *a.shape)
    content += b''.join(a.astype('<f2').tobytes() for a in arrays)
    with open(path, 'wb') as file:
        file.write(content + struct.pack('<I', zlib.crc32(content)))
