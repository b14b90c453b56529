"""Tables: numpy structured arrays; as a DataFrame where pandas is installed."""

import numpy as np

from .errors import FaceNavError


def table_of(rows, columns):
    """A structured array of rows (dicts). `columns`: (name, type) or (name, type, shape); "U" is text of any length."""
    widths = {name: max([1, *(len(row[name]) for row in rows)]) for name, kind, *_ in columns if kind == "U"}
    kinds = np.dtype([(name, f"U{widths[name]}" if kind == "U" else kind, *shape) for name, kind, *shape in columns])
    table = np.zeros(len(rows), kinds)
    for n, row in enumerate(rows):
        table[n] = tuple(row[name] for name in kinds.names)
    return table


def require_columns(table, columns, what):
    """Throws unless `table` is a structured array with these columns."""
    names = {name for name, *_ in columns}
    if not isinstance(table, np.ndarray) or table.dtype.names is None or names - set(table.dtype.names):
        raise FaceNavError("", f"a structured array of {what} was expected")
    return table


def as_pandas(table):
    """A structured array as a DataFrame; a field of several numbers (a pose) becomes a column of arrays."""
    try:
        import pandas
    except ImportError as fault:
        raise FaceNavError("", "pandas is not installed") from fault
    if not isinstance(table, np.ndarray) or table.dtype.names is None:
        raise FaceNavError("", "a structured array was expected")
    return pandas.DataFrame({name: list(table[name]) if table[name].ndim > 1 else table[name]
                             for name in table.dtype.names})
