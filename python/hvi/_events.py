# Events: places where an expression vanishes along a trajectory.
# SPDX-License-Identifier: MIT
from __future__ import annotations

import dataclasses
import math
from typing import Any, Callable, Mapping, Sequence

import numpy as np

from ._expressions import compiled

#: Events in one step of which the run says that they have no end.
most_in_a_step = 1000


@dataclasses.dataclass
class Event:
    """An event: `zero` is an expression such as `"y"`, or a function f(t, y).

    What crosses zero twice within one step is not seen. The root is found by retaking the step
    with other lengths, so that invariants hold there to rounding.
    """

    zero: str | Callable[[float, np.ndarray], float]
    direction: str | float = "both"  #: "up", "down" or "both"; or a number with that sign
    stop: bool | int = False  #: the n-th ends the run; True is 1
    set: Mapping[str, str | float] | None = None  #: what variables become there
    cooldown: float = 0.0  #: time in which it does not count again
    period: float | None = None  #: `zero` is an angle with this period

    @classmethod
    def of(cls, event: Any) -> "Event":
        """An event of an expression, or of a function with scipy's attributes."""
        if isinstance(event, cls):
            return event
        if isinstance(event, str):
            return cls(event)
        if callable(event):
            return cls(event, getattr(event, "direction", 0.0), getattr(event, "terminal", False))
        raise TypeError(f"an event is an expression, a function or an Event, and not {event!r}")

    def sign(self) -> int:
        """1 for up, -1 for down, 0 for both. Raises ValueError for another word."""
        if isinstance(self.direction, str):
            signs = {"up": 1, "down": -1, "both": 0}
            if self.direction not in signs:
                raise ValueError(f"direction is up, down or both, and not {self.direction!r}")
            return signs[self.direction]
        return (self.direction > 0) - (self.direction < 0)


class WatchedEvent:
    """An event in a run: its function, and what was seen of it."""

    def __init__(self, event: Any, variables: Sequence[str], parameters: Mapping[str, float]):
        self.event = Event.of(event)
        self.sign = self.event.sign()
        zero = self.event.zero
        known = dict(parameters)
        self.zero = compiled(zero, variables, known) if isinstance(zero, str) else zero
        self.jumps = []
        for name, value in (self.event.set or {}).items():
            if name not in variables:
                raise ValueError(f"an event sets {name!r}, which is none of {', '.join(variables)}")
            self.jumps.append((variables.index(name), compiled(str(value), variables, known)))
        self.times: list[float] = []
        self.states: list[np.ndarray] = []
        self.last = math.nan  #: the value where the piece of the step began

    def value(self, t: float, y: np.ndarray) -> float:
        """`zero` there; of an angle what is left of whole turns, between its halves."""
        value = float(self.zero(t, y))
        return value if self.event.period is None else math.remainder(value, self.event.period)

    def crosses(self, before: float, after: float) -> bool:
        """Whether there is a root between. A turn is none, and a root counts where it is reached."""
        if before == 0 or before * after > 0 or before != before or after != after:
            return False
        if self.event.period is not None and abs(after - before) > self.event.period / 2:
            return False
        return self.sign == 0 or (before < 0) == (self.sign > 0)

    def is_cool(self, t: float) -> bool:
        return not self.times or abs(t - self.times[-1]) >= self.event.cooldown

    def ends(self) -> bool:
        stop = int(self.event.stop)
        return stop > 0 and len(self.times) >= stop

    def jump(self, t: float, y: np.ndarray) -> None:
        """All variables are set at once, of the values before."""
        values = [(index, value(t, y)) for index, value in self.jumps]
        for index, value in values:
            y[index] = value


def root(value: Callable[[float], float], low: float, at_low: float, high: float, at_high: float,
         smallest: float) -> float:
    """The place between `low` and `high` where a function changes its sign, to `smallest`.

    Chandrupatla's method: inverse quadratic interpolation where it converges, halving elsewhere
    (T. R. Chandrupatla, Adv. Eng. Softw. 28, 145, 1997).
    """
    a, b, c = high, low, low
    fa, fb, fc = at_high, at_low, at_low
    share = 0.5
    while True:
        x = a + share * (b - a)
        fx = value(x)
        if fx == 0:
            return x
        if (fx > 0) == (fa > 0):
            c, fc = a, fa
        else:
            c, b, fc, fb = b, a, fb, fa
        a, fa = x, fx
        best = a if abs(fa) < abs(fb) else b
        limit = smallest / abs(b - a) if b != a else 1.0
        if limit > 0.5:
            return best
        xi, phi = (a - b) / (c - b), (fa - fb) / (fc - fb)
        if phi * phi < xi and (1 - phi) * (1 - phi) < 1 - xi:
            share = (fa / (fb - fa) * fc / (fb - fc)
                     + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb))
        else:
            share = 0.5
        share = min(1 - limit, max(limit, share))
