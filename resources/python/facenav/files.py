"""Files as FaceNav writes them: whole or not at all, for their owner alone; JSON and CSV with clear errors."""

import csv
import io
import json
import math
import os
import tempfile
from pathlib import Path

from .errors import FaceNavError

LARGEST_NUMBER = 1e16


def write_whole(path, content):
    """Writes text or bytes as a whole file (temporary name, fsync, rename), 0600."""
    path = Path(path).resolve()  # a link stays one
    data = content.encode("utf-8") if isinstance(content, str) else content
    try:
        handle, temporary = tempfile.mkstemp(dir=path.parent, prefix="." + path.name)
    except OSError as fault:
        raise FaceNavError(path, f"cannot be written ({fault.strerror})") from fault
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(data)
            stream.flush()
            os.fsync(stream.fileno())
        os.replace(temporary, path)
    except OSError as fault:
        os.unlink(temporary)
        raise FaceNavError(path, f"cannot be written ({fault.strerror})") from fault


def read_bytes(path):
    try:
        return Path(path).read_bytes()
    except OSError as fault:
        raise FaceNavError(path, f"cannot be read ({fault.strerror})") from fault


def read_text(path):
    try:
        return read_bytes(path).decode("utf-8")
    except UnicodeDecodeError as fault:
        raise FaceNavError(path, "is not UTF-8 text") from fault


def _no_constant(word):
    raise ValueError(f"{word} is no number")


def parse_json(text, where):
    """The object in `text`. NaN and Infinity are refused."""
    try:
        value = json.loads(text, parse_constant=_no_constant)
    except (ValueError, RecursionError) as fault:
        raise FaceNavError(where, f"is not JSON ({fault})") from fault
    if not isinstance(value, dict):
        raise FaceNavError(where, "holds no JSON object")
    return value


def read_json(path):
    return parse_json(read_text(path), path)


def read_json_lines(path):
    """One object a line; a last line that was cut short is left out, as FaceNav does."""
    text = read_text(path)
    lines = text.split("\n")
    if lines[-1]:
        try:
            json.loads(lines[-1])
        except ValueError:
            lines.pop()
    return [parse_json(line, f"{path}, line {n}") for n, line in enumerate(lines, 1) if line.strip()]


def member(json_object, key, where):
    if key not in json_object:
        raise FaceNavError(where, f"has no '{key}'")
    return json_object[key]


def number_of(value, where):
    """A finite number of usable size; bool and text are refused."""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise FaceNavError(where, f"a number was expected, not {value!r}")
    if not math.isfinite(value) or abs(value) > LARGEST_NUMBER:
        raise FaceNavError(where, f"{value} is no usable number")
    return float(value)


def numbers_of(value, count, where):
    if not isinstance(value, (list, tuple)) or len(value) != count:
        raise FaceNavError(where, f"{count} numbers were expected")
    return [number_of(one, where) for one in value]


def text_of(value, where):
    if not isinstance(value, str):
        raise FaceNavError(where, f"text was expected, not {value!r}")
    return value


def read_csv(path, required):
    """Rows as dicts by the names of the header. Throws if a required column is absent or a row has another length."""
    rows = list(csv.reader(io.StringIO(read_text(path), newline="")))
    if not rows or not any(rows[0]):
        raise FaceNavError(path, "has no header line")
    header = rows[0]
    for name in required:
        if name not in header:
            raise FaceNavError(path, f"has no column '{name}'")
    table = []
    for line, row in enumerate(rows[1:], 2):
        if not row:
            continue
        if len(row) != len(header):
            raise FaceNavError(f"{path}, line {line}", f"has {len(row)} fields, not {len(header)}")
        table.append(dict(zip(header, row)))
    return table


def csv_number(row, key, where):
    """The number in a field; NaN if the field is empty or the column absent."""
    text = row.get(key, "")
    if text == "":
        return math.nan
    try:
        value = float(text)
    except ValueError as fault:
        raise FaceNavError(where, f"'{text}' in column '{key}' is no number") from fault
    return number_of(value, f"{where}, column '{key}'")


def csv_required(row, key, where):
    """The number in a field that must not be empty."""
    value = csv_number(row, key, where)
    if math.isnan(value):
        raise FaceNavError(where, f"a number was expected in column '{key}'")
    return value


def csv_integer(row, key, where):
    value = csv_required(row, key, where)
    if value != int(value):
        raise FaceNavError(where, f"a whole number was expected in column '{key}'")
    return int(value)


def csv_text(header, rows):
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(header)
    writer.writerows(rows)
    return stream.getvalue()


def number_text(value, decimals):
    """Fixed decimals; empty for NaN, which stands for 'not known'."""
    return "" if value is None or math.isnan(value) else f"{value:.{decimals}f}"
