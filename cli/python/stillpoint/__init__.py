# SPDX-License-Identifier: MIT
"""Design of friction dampers."""


class Fields(dict):
    """A part of a report: its fields as attributes and as keys."""

    __slots__ = ()

    def __getattr__(self, name):
        try:
            return self[name]
        except KeyError:
            raise AttributeError(f"the report has no field '{name}'") from None

    def __dir__(self):
        return [*super().__dir__(), *self]

    def __repr__(self):
        return f"Fields({', '.join(f'{name}={value!r}' for name, value in self.items())})"


from ._stillpoint import *  # noqa: E402,F403
