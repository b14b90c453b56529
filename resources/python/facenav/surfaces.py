"""Surfaces of a case: VTK's XML PolyData (.vtp), read without VTK."""

import base64
import xml.etree.ElementTree as ElementTree
import zlib
from dataclasses import dataclass, field

import numpy as np

from .errors import FaceNavError
from .files import read_bytes

_TYPES = {"Int8": "i1", "UInt8": "u1", "Int16": "i2", "UInt16": "u2", "Int32": "i4", "UInt32": "u4",
          "Int64": "i8", "UInt64": "u8", "Float32": "f4", "Float64": "f8"}


@dataclass
class Surface:
    """Triangles in Mri. `point_data`: arrays of a value (or a row) a point; `field_data`: arrays of the whole."""

    points_mm: np.ndarray  # n x 3
    triangles: np.ndarray  # m x 3, indices of points
    point_data: dict = field(default_factory=dict)
    field_data: dict = field(default_factory=dict)

    @property
    def normals(self):
        """Unit normals at the points, outward; None if the file has none."""
        return self.point_data.get("Normals")


class _Reader:
    def __init__(self, path):
        self.path = path
        self.head, self.appended, self.is_raw = self._split(read_bytes(path))
        try:
            self.root = ElementTree.fromstring(self.head)
        except ElementTree.ParseError as fault:
            raise FaceNavError(path, f"is no VTK surface ({fault})") from fault
        if self.root.tag != "VTKFile" or self.root.get("type") != "PolyData":
            raise FaceNavError(path, "is no VTK surface (PolyData)")
        self.order = ">" if self.root.get("byte_order") == "BigEndian" else "<"
        self.header = np.dtype(self.order + ("u8" if self.root.get("header_type") == "UInt64" else "u4"))
        compressor = self.root.get("compressor")
        if compressor not in (None, "vtkZLibDataCompressor"):
            raise FaceNavError(path, f"is compressed by {compressor}, which is not read")
        self.is_compressed = compressor is not None

    @staticmethod
    def _split(data):
        """XML without appended data, and the appended data: raw bytes may be no XML."""
        start = data.find(b"<AppendedData")
        if start < 0:
            return data, b"", False
        begin = data.find(b"_", data.find(b">", start)) + 1
        end = data.rfind(b"</AppendedData>")
        is_raw = b'encoding="raw"' in data[start:begin]
        return data[:start] + b"</VTKFile>", data[begin:end if end > 0 else len(data)], is_raw

    def array(self, element):
        """Values of a DataArray; one row a tuple where it has several components."""
        kind = _TYPES.get(element.get("type"))
        if kind is None:
            return None  # text
        form = element.get("format", "ascii")
        if form == "ascii":
            values = np.array((element.text or "").split(), dtype=self.order + kind)
        elif form == "binary":
            values = np.frombuffer(self._base64((element.text or "").strip().encode()), self.order + kind)
        else:
            offset = int(element.get("offset", "0"))
            block = self.appended[offset:]
            content = self._raw(block) if self.is_raw else self._base64(block)
            values = np.frombuffer(content, self.order + kind)
        components = int(element.get("NumberOfComponents", "1"))
        values = values.astype(kind)
        return values.reshape(-1, components) if components > 1 else values

    def _lengths(self, head):
        """Number of header words, and the compressed sizes of the blocks."""
        count = int(np.frombuffer(head[:self.header.itemsize], self.header)[0])
        return 3 + count

    def _base64(self, text):
        size = self.header.itemsize
        decode = lambda count: base64.b64decode(text[:(count + 2) // 3 * 4])[:count]
        if not self.is_compressed:
            length = int(np.frombuffer(decode(size), self.header)[0])
            return decode(size + length)[size:]
        words = self._lengths(decode(size))
        sizes = np.frombuffer(decode(words * size), self.header)[3:]
        body = text[(words * size + 2) // 3 * 4:]
        return self._inflate(base64.b64decode(body[:(int(sizes.sum()) + 2) // 3 * 4]), sizes)

    def _raw(self, data):
        size = self.header.itemsize
        if not self.is_compressed:
            length = int(np.frombuffer(data[:size], self.header)[0])
            return data[size:size + length]
        words = self._lengths(data)
        sizes = np.frombuffer(data[:words * size], self.header)[3:]
        return self._inflate(data[words * size:], sizes)

    @staticmethod
    def _inflate(data, sizes):
        content, at = [], 0
        for size in sizes:
            content.append(zlib.decompress(data[at:at + int(size)]))
            at += int(size)
        return b"".join(content)

    def named(self, parent):
        found = {}
        for element in parent.iter("DataArray") if parent is not None else ():
            values = self.array(element)
            if values is not None:
                found[element.get("Name")] = values
        return found


def _triangles(polys, path):
    connectivity, offsets = polys.get("connectivity"), polys.get("offsets")
    if connectivity is None or offsets is None:
        raise FaceNavError(path, "holds no triangles")
    if len(offsets) and not (np.diff(np.concatenate([[0], offsets])) == 3).all():
        raise FaceNavError(path, "holds cells that are no triangles")
    return connectivity.reshape(-1, 3)


def read_surface(path):
    """Reads a .vtp of triangles, as a case holds them."""
    reader = _Reader(path)
    try:
        piece = reader.root.find("PolyData/Piece")
        points = None if piece is None else piece.find("Points/DataArray")
        if points is None:
            raise FaceNavError(path, "holds no points")
        surface = Surface(np.asarray(reader.array(points), dtype=float).reshape(-1, 3),
                          _triangles(reader.named(piece.find("Polys")), path),
                          reader.named(piece.find("PointData")), reader.named(reader.root.find("PolyData/FieldData")))
    except (ValueError, IndexError, zlib.error) as fault:
        if isinstance(fault, FaceNavError):
            raise
        raise FaceNavError(path, f"is damaged ({fault})") from fault
    count = len(surface.points_mm)
    if not np.isfinite(surface.points_mm).all():
        raise FaceNavError(path, "holds points that are no places")
    if len(surface.triangles) and not (0 <= surface.triangles.min() and surface.triangles.max() < count):
        raise FaceNavError(path, "holds triangles of points that are not there")
    return surface
