# SPDX-License-Identifier: MIT
"""Design of friction dampers for vibration and seismic isolation.

design, region, simulate, spectrum and sweep take the options of the program's commands as keyword
arguments, with '_' for '-'. Their results have the fields of the JSON report as attributes and the
whole report as a dict, report; a notebook shows their figures. read_record reads an acceleration
record. Wrong input raises InputError, a ValueError with the text that the program prints.
"""

import functools
import types


class Fields(dict):
    """A part of a report: its fields as attributes and as keys."""

    __slots__ = ()

    def __getattr__(self, name):
        try:
            return self[name]
        except KeyError:
            raise AttributeError(f"there is no field '{name}'") from None

    def __dir__(self):
        return [*super().__dir__(), *self]

    def __repr__(self):
        return f"Fields({', '.join(f'{name}={value!r}' for name, value in self.items())})"


from . import _stillpoint  # noqa: E402
from ._stillpoint import *  # noqa: E402, F403
from ._stillpoint import __version__  # noqa: E402, F401


def _named(function):
    """A function of the module that pickles by its name, as pools of processes need."""

    @functools.wraps(function)
    def call(*arguments, **options):
        return function(*arguments, **options)

    call.__module__ = __name__
    call.__qualname__ = function.__name__
    return call


for _name, _one in vars(_stillpoint).items():
    if isinstance(_one, types.BuiltinFunctionType):
        globals()[_name] = _named(_one)

__all__ = [
    "Fields",
    "InputError",
    "Motion",
    "Result",
    "Sweep",
    "design",
    "options",
    "outcomes",
    "read_record",
    "region",
    "simulate",
    "spectrum",
    "sweep",
]
