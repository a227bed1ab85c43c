# SPDX-License-Identifier: Apache-2.0
"""Reads arrays and pictures by hand, with nothing of what wrote them."""
import ast, struct, zlib


def read(path, mode='rb'):
    with open(path, mode) as f: return f.read()


def read_npy(path):
    """Type, shape and the bytes; the header by hand."""
    data = read(path)
    assert data[:8] == b'\x93NUMPY\x01\x00', data[:8]
    length = struct.unpack('<H', data[8:10])[0]
    assert (10 + length) % 64 == 0 and data[9 + length:10 + length] == b'\n'
    header = ast.literal_eval(data[10:10 + length].decode('latin1'))
    assert header['fortran_order'] is False
    return header['descr'], header['shape'], data[10 + length:]


def read_png(path):
    """Size, depth, kind of colour and the unpacked rows; every checksum is held."""
    data = read(path)
    assert data[:8] == b'\x89PNG\r\n\x1a\n'
    at, chunks = 8, []
    while at < len(data):
        size, kind = struct.unpack('>I4s', data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        assert zlib.crc32(kind + body) == struct.unpack('>I', data[at + 8 + size:at + 12 + size])[0], kind
        chunks.append((kind, body))
        at += 12 + size
    assert chunks[0][0] == b'IHDR' and chunks[-1] == (b'IEND', b'') and not {b'tIME', b'tEXt'} & {k for k, _ in chunks}
    return struct.unpack('>IIBB', chunks[0][1][:10]), zlib.decompress(b''.join(b for k, b in chunks if k == b'IDAT'))
