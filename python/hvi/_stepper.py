# Steps of a compiled stepper, one by one and many.
# SPDX-License-Identifier: MIT
from __future__ import annotations

import math
import sys
import time
import warnings
from ctypes import byref, c_int64, c_size_t, c_void_p
from typing import Any, Iterable, Mapping, Sequence

import numpy as np

from ._events import WatchedEvent, most_in_a_step, root
from ._library import Library, StepError
from ._result import Result

#: Rows of a table where nobody says how many.
_usual_rows = 1000

_seconds_of_a_call = 0.1


class Stepper:
    """A stepper with values of its parameters, and what it keeps from one step to the next.

    A state is an array of doubles: q, then p, then t where H depends on the time. One stepper is
    for one thread at a time; `copy()` makes another.
    """

    def __init__(self, library: Library, parameters: Mapping[str, Any] | None = None):
        self._handle: int | None = None
        self._library = library
        self._parameters = dict(parameters or {})
        self._handle = library.create(self._parameters)
        self._bind_names()

    def _bind_names(self) -> None:
        library, handle = self._library, self._handle
        assert handle is not None
        self._state: np.ndarray | None = None
        self._address = 0
        self._step = library.step
        self.dof: int = library.dof(handle)  #: degrees of freedom
        self.size: int = library.size(handle)  #: numbers of a state
        self.coordinates: list[str] = library.coordinates(handle)
        self.momenta: list[str] = library.momenta(handle)
        self.variables = self.coordinates + self.momenta

    def __del__(self) -> None:
        if getattr(self, "_handle", None) is not None:
            self._library.destroy(self._handle)

    @property
    def description(self):
        """Facts of the scene and the method."""
        return self._library.description

    @property
    def parameters(self) -> dict[str, Any]:
        """All parameters that are numbers with their values, and lists that were given."""
        return self._library.parameters(self._parameters)

    def copy(self) -> "Stepper":
        """Makes another stepper that goes on, bit by bit, as this one would."""
        other = object.__new__(type(self))
        other._handle = None
        handle = c_void_p()
        self._library.check(self._library.copy(self._handle, byref(handle)))
        other._library, other._parameters = self._library, self._parameters
        other._handle = handle.value
        other._bind_names()
        return other

    def reset(self) -> None:
        """Forgets what the last step left: remainders of sums, starting values of iterations."""
        self._library.check(self._library.reset(self._handle))

    def initial(self) -> np.ndarray:
        """The state in which the scene begins."""
        state = np.empty(self.size)
        self._library.check(self._library.initial(self._handle, state.ctypes.data))
        return state

    def step(self, x: np.ndarray, h: float) -> None:
        """Advances the state by a time h, in place.

        Raises StepError where the step cannot be taken; the state has then kept its bits.
        """
        if x is not self._state:
            self._bind(x)
        status = self._step(self._handle, self._address, h)
        if status:
            self._library.check(status)

    def _bind(self, x: np.ndarray) -> None:
        """Takes the address of an array. NOTE: numpy moves no array that somebody refers to."""
        is_state = (isinstance(x, np.ndarray) and x.dtype == np.float64 and x.size == self.size
                    and x.flags.c_contiguous and x.flags.writeable)
        if not is_state:
            raise TypeError(f"a state is a writable array of {self.size} doubles in a row")
        self._state, self._address = x, x.ctypes.data

    def energy(self, x: np.ndarray) -> float:
        """H at a state."""
        value = np.empty(1)
        state = self._as_state(x)
        self._library.check(self._library.energy(self._handle, state.ctypes.data,
                                                 value.ctypes.data))
        return float(value[0])

    def invariants(self, x: np.ndarray) -> dict[str, float]:
        """The scene's invariants at a state, by their names."""
        names = self._library.invariant_names()
        values, state = np.empty(len(names)), self._as_state(x)
        if names:
            self._library.check(self._library.invariants(self._handle, state.ctypes.data,
                                                         values.ctypes.data))
        return dict(zip(names, values.tolist()))

    def _as_state(self, x: Any) -> np.ndarray:
        """A copy as numbers that C can read. The time may be left out where it is 0."""
        state = np.array(x, dtype=float).ravel()
        if self.description.has_time and state.size == self.size - 1:
            state = np.append(state, 0.0)
        if state.size != self.size:
            raise ValueError(f"a state has {self.size} numbers, and not {state.size}: "
                             + ", ".join(self.variables))
        return state

    def evaluations(self) -> int:
        """How often dH/dq was computed since the stepper was made."""
        count = c_int64()
        self._library.check(self._library.counts(self._handle, None, None, byref(count)))
        return count.value

    def integrate(self, x: Any = None, t_span: Sequence[float] | None = None,
                  step: float | None = None, *, t_eval: Any = None, every: int | None = None,
                  events: Any = None, dense_output: bool = False,
                  progress: bool = False) -> Result:
        """Takes steps of size `step` from a state, and returns a table of the trajectory.

        Without `x` it begins where the scene does; without `t_span` and `step` these are the
        scene's. Rows are at `t_eval`, or after each `every` steps, as many as make at most 1000
        rows without; the last row is at the end. Rows between two steps are reached by a shorter
        step from the one before, and leave the bits of the trajectory as they are. `events` is an
        expression, an Event, a function f(t, y) with scipy's `terminal` and `direction`, or
        several of them; a function or an expression is looked at after each step, which takes
        microseconds. `dense_output` gives `sol`, which takes steps again from the row before.

        Raises ValueError for times that cannot be. A step that fails ends the run: the result has
        `success` False, and the rows up to there.
        """
        return Integration(self, x, t_span, step).run(t_eval, every, events, dense_output, progress)


class Integration:
    """A run of a stepper over a grid of steps."""

    def __init__(self, stepper: Stepper, x: Any, t_span: Sequence[float] | None,
                 step: float | None):
        about = stepper.description
        self.stepper, self.library = stepper, stepper._library
        if t_span is None:
            if about.until is None:
                raise ValueError("t_span is missing, and the scene has no end of its own")
            t_span = (0.0, about.until)
        self.begin, self.end = float(t_span[0]), float(t_span[1])
        h = about.step if step is None else float(step)
        if h is None:
            raise ValueError("step is missing, and the scene has none of its own")
        if not (math.isfinite(self.begin) and math.isfinite(self.end)):
            raise ValueError("the times of t_span are finite")
        if not math.isfinite(h) or h == 0:
            raise ValueError("a step is finite and not 0")
        self.h = math.copysign(h, self.end - self.begin) if self.end != self.begin else h
        # NOTE: of a quotient that is a whole number but for rounding, no step is lost.
        quotient = (self.end - self.begin) / self.h
        self.steps = math.floor(quotient * (1 + 4e-16) + 1e-9)
        self.state = stepper.initial() if x is None else stepper._as_state(x)
        if about.has_time:
            self.state[-1] = self.begin
        if not np.all(np.isfinite(self.state)):
            raise ValueError("a state has finite numbers")
        self.invariants = self.library.invariant_names()
        self.width = 1 + len(stepper.variables) + 1 + len(self.invariants)
        self.columns = None
        self.status, self.message = 0, "the end was reached"
        self.short: Stepper | None = None  #: takes short steps
        self.bar: Progress | None = None
        self.done = 0  #: steps

    def run(self, t_eval: Any, every: int | None, events: Any, dense: bool,
            progress: bool) -> Result:
        stepper = self.stepper
        evaluations = stepper.evaluations()
        stepper.reset()
        first = self.state.copy()
        watched = self._watched(events)
        self.bar = Progress(self.steps) if progress else None
        if t_eval is not None:
            table = self._at_times(self._times(t_eval), watched)
        else:
            every = max(1, -(-self.steps // _usual_rows)) if every is None else int(every)
            if every < 1:
                raise ValueError("every is at least 1")
            table = (self._watching(self._grid(every), watched) if watched
                     else self._in_a_row(every))
        if self.bar:
            self.bar.close()
        result = self._result(table, watched)
        result.nfev = stepper.evaluations() - evaluations
        if not any(each.jumps for each in watched):
            self._warn_of_energy(result)
        if dense:
            has_jumps = any(each.jumps for each in watched)
            if has_jumps:
                raise ValueError("dense_output does not go with events that set variables")
            result.sol = Curve(stepper, first, self.begin, self.h, result)
        return result

    def _warn_of_energy(self, result: Result) -> None:
        """Warns where the energy changes by more than a tenth of its scale, as hvi-gen does.

        The scale is the larger of |H| at the start and of the mean size of H(q, p) - H(q, 0).
        """
        if self.stepper.description.has_time or len(result.t) == 0:
            return
        change = float(np.max(np.abs(result.energy - result.energy[0])))
        if not change > 0.1 * abs(result.energy[0]):
            return
        rows = range(0, len(result.t), max(1, len(result.t) // 100))
        motion = [result.energy[k] - self.stepper.energy([*result.q[:, k], *0 * result.p[:, k]])
                  for k in rows]
        scale = max(abs(result.energy[0]), float(np.mean(np.abs(motion))))
        if change > 0.1 * scale > 0:
            warnings.warn(f"the energy changes by {change:.2g}, of a scale of {scale:.2g}: the "
                          "step is too large", RuntimeWarning, stacklevel=5)

    def _watched(self, events: Any) -> list[WatchedEvent]:
        if events is None:
            return []
        several = isinstance(events, Iterable) and not isinstance(events, str)
        numbers = {name: value for name, value in self.stepper.parameters.items()
                   if np.ndim(value) == 0}
        return [WatchedEvent(each, self.stepper.variables, numbers)
                for each in (events if several else [events])]

    def _times(self, t_eval: Any) -> np.ndarray:
        times = np.array(t_eval, dtype=float).ravel()
        ahead = math.copysign(1.0, self.h)
        if times.size and not (np.all(ahead * np.diff(times) > 0)
                               and ahead * (times[0] - self.begin) >= 0
                               and ahead * (self.end - times[-1]) >= 0):
            raise ValueError("t_eval is in order and within t_span")
        return times

    def _grid(self, every: int) -> np.ndarray:
        """Times of rows: of each `every` steps, and the end."""
        times = self.begin + self.h * np.arange(0, self.steps + 1, every)
        return np.append(times[:-1] if self._is_end(times[-1]) else times, self.end)

    def _is_end(self, t: float) -> bool:
        return abs(self.end - t) <= 1e-9 * abs(self.h)

    # ---- many steps in C ----

    def _take(self, steps: int, every: int, rows: np.ndarray | None) -> int:
        """Takes steps from the state, rows of which go to `rows`; returns how many were written.

        NOTE: it comes back to Python ten times a second, so that Ctrl-C is heard: also between two
        rows.
        """
        written, count, since = c_size_t(), 0, 0  # `since`: steps since the last row
        most = 1000
        while steps > 0 and self.status == 0:
            if since == 0 and most >= every:
                piece, each = min(most // every * every, steps), every
            else:
                piece = each = min(most, every - since, steps)
            has_rows = rows is not None and since + piece >= every
            table = rows[count:] if has_rows else None
            began = time.perf_counter()
            status = self.library.integrate(
                self.stepper._handle, self.state.ctypes.data, self.begin + self.h * self.done,
                self.h, piece, each, None if table is None else self._names(),
                None if table is None or not table.size else table.ctypes.data,
                0 if table is None else len(table), byref(written))
            self._took(piece, time.perf_counter() - began)
            if status != 0:
                self._failed(status)
            count += written.value if has_rows else 0
            steps -= piece
            since = (since + piece) % every
            seconds = max(time.perf_counter() - began, 1e-6)
            most = min(10 * most, max(1, int(piece * _seconds_of_a_call / seconds)))
        return count

    def _took(self, steps: int, seconds: float) -> None:
        self.done += steps
        if self.bar:
            self.bar.show(self.done, seconds)

    def _names(self) -> bytes:
        if self.columns is None:
            self.columns = ", ".join(
                ["t", *self._families(), "energy", *self.invariants]).encode()
        return self.columns

    def _families(self) -> list[str]:
        names = []
        for kind in (1, 2):
            names += [self.library.name(kind, k).decode()
                      for k in range(self.library.count(kind))]
        return names

    def _failed(self, status: int) -> None:
        self.status, self.message = -1, self.library.text_of(status)

    def _row(self, t: float, x: np.ndarray) -> np.ndarray:
        stepper = self.stepper
        values = stepper.invariants(x) if self.invariants else {}
        return np.concatenate([[t], x[: len(stepper.variables)], [stepper.energy(x)],
                               list(values.values())])

    def _in_a_row(self, every: int) -> np.ndarray:
        """A table whose rows C fills, with one for the start and one for the end."""
        count = self.steps // every
        table = np.empty((count + 2, self.width))
        table[0] = self._row(self.begin, self.state)
        filled = 1 + self._take(count * every, every, table[1:count + 1])
        self._take(self.steps - count * every, 1, None)
        last = self.begin + self.h * self.steps
        if self.status == 0 and not (self._is_end(last) and filled > 1 and
                                     self.steps == count * every) and self.steps >= 0:
            state = self.state
            if not self._is_end(last):
                state = self._shortly(self.state, self.end - last)
            if state is not None and self.end != self.begin:
                table[filled] = self._row(self.end, state)
                filled += 1
        if self._is_end(table[filled - 1, 0]):
            table[filled - 1, 0] = self.end  # but for rounding it was
        return table[:filled]

    def _shortly(self, x: np.ndarray, h: float) -> np.ndarray | None:
        """The state after a step of that size from x; None, with the status, where there is none."""
        if h == 0:
            return x.copy()
        if self.short is None:
            self.short = self.stepper.copy()
        self.short.reset()
        state = x.copy()
        status = self.library.step(self.short._handle, state.ctypes.data, h)
        if status != 0:
            self._failed(status)
            return None
        return state

    def to_end(self) -> tuple[float, np.ndarray, float, int, str]:
        """Takes all steps; the time, the state and the change of the energy there, and how it went."""
        stepper = self.stepper
        stepper.reset()
        before = stepper.energy(self.state)
        self._take(self.steps, 1, None)
        t = self.begin + self.h * self.done
        if self.status == 0 and not self._is_end(t):
            x = self._shortly(self.state, self.end - t)
            self.state, t = (self.state, t) if x is None else (x, self.end)
        change = stepper.energy(self.state) - before
        variables = len(stepper.variables)
        return t, self.state[:variables].copy(), change, self.status, self.message

    # ---- rows at given times, and events ----

    def _at_times(self, times: np.ndarray, watched: list[WatchedEvent]) -> np.ndarray:
        if watched:
            return self._watching(times, watched)
        rows = []
        for t in times:
            place = (t - self.begin) / self.h
            steps = min(math.floor(place + 1e-9), self.steps)
            self._take(steps - self.done, 1, None)
            at = self.begin + self.h * self.done
            is_there = abs(t - at) <= 1e-9 * abs(self.h)
            x = None if self.status else self._shortly(self.state, 0.0 if is_there else t - at)
            if x is None:
                break
            rows.append(self._row(t, x))
        if self.status == 0:
            self._take(self.steps - self.done, 1, None)
        return self._table(rows)

    def _table(self, rows: list[np.ndarray]) -> np.ndarray:
        return np.array(rows) if rows else np.empty((0, self.width))

    def _watching(self, times: np.ndarray, watched: list[WatchedEvent]) -> np.ndarray:
        """Takes each step by itself, and looks for events in it."""
        rows: list[np.ndarray] = []
        waiting = list(times[::-1])
        for each in watched:
            each.last = each.value(self.begin, self.state)
        took = time.perf_counter()
        while self.status == 0 and not self._is_end(self._now()):
            self._watch_step(watched, waiting, rows)
            if self.bar and self.done % 1000 == 0:
                self.bar.show(self.done, time.perf_counter() - took)
        while waiting and self.status == 0 and self._is_end(waiting[-1]):
            rows.append(self._row(waiting.pop(), self.state))
        return self._table(rows)

    def _now(self) -> float:
        last = self.begin + self.h * self.done
        return self.end if self.done > self.steps else last

    def _watch_step(self, watched: list[WatchedEvent], waiting: list[float],
                    rows: list[np.ndarray]) -> None:
        """Takes a step, the last of which may be a short one, in pieces between jumps."""
        t = self._now()
        is_whole = self.done < self.steps
        end = self.begin + self.h * (self.done + 1) if is_whole else self.end
        start = self.state.copy()
        for _ in range(most_in_a_step):
            length = self.h if is_whole and t == self._now() else end - t
            x = self._whole(start) if length == self.h else self._shortly(start, length)
            if x is None:
                self._rows_until(waiting, rows, t, start, t)
                return
            event, at, there = self._first(watched, t, start, end, x)
            near = 1e-9 * self.h if event is None and is_whole else 0.0
            self._rows_until(waiting, rows, t, start, end - near if event is None else at)
            if event is None:
                self.state = x
                self.done += 1
                return
            if event.ends():
                self.state, self.status = there, 1
                self.message = "an event has ended the run"
                self.stopped = at
                rows.append(self._row(at, there))
                return
            # A jump: the rest of the step begins behind it.
            start, t, is_whole = there, at, False
            event.jump(at, start)
            self.stepper.reset()
            for each in watched:
                each.last = 0.0 if each is event else each.value(t, start)
            if t == end:
                self.state = start
                self.done += 1
                return
        self.status = -1
        self.message = f"there are more than {most_in_a_step} events in a step"

    def _whole(self, start: np.ndarray) -> np.ndarray | None:
        state = start.copy()
        status = self.library.step(self.stepper._handle, state.ctypes.data, self.h)
        if status != 0:
            self._failed(status)
            return None
        return state

    def _first(self, watched: list[WatchedEvent], t: float, start: np.ndarray, end: float,
               x: np.ndarray):
        """Notes the events between two states, up to the first that ends the run or jumps.

        Returns that event, its time and its state; None for all three where there is none.
        """
        found = []
        for number, each in enumerate(watched):
            value = each.value(end, x)
            if each.crosses(each.last, value):
                s = self._root(each, t, start, end, value)
                if s is None:
                    return None, None, None
                found.append((abs(s), number, s))
            each.last = value
        for _, number, s in sorted(found):
            each, at = watched[number], t + s
            if not each.is_cool(at):
                continue
            state = x.copy() if at == end else self._shortly(start, s)
            if state is None:
                return None, None, None
            each.times.append(at)
            each.states.append(state[: len(self.stepper.variables)].copy())
            if each.ends() or each.jumps:
                return each, at, state
        return None, None, None

    def _root(self, event: WatchedEvent, t: float, start: np.ndarray, end: float,
              value: float) -> float | None:
        length = end - t
        if value == 0:
            return length

        def at(s: float) -> float:
            x = self._shortly(start, s)
            if x is None:
                raise StepError(self.message)
            return event.value(t + s, x)

        smallest = 2 * math.ulp(max(abs(t), abs(end), abs(length)))
        try:
            return root(at, 0.0, event.last, length, value, smallest)
        except StepError:
            return None

    def _rows_until(self, waiting: list[float], rows: list[np.ndarray], t: float,
                    start: np.ndarray, end: float) -> None:
        """Rows at times from t up to `end`, but not there, by short steps from `start`."""
        ahead = math.copysign(1.0, self.h)
        while waiting and ahead * (end - waiting[-1]) > 0:
            at = waiting[-1]
            is_there = abs(at - t) <= 1e-9 * abs(self.h)
            x = self._shortly(start, 0.0 if is_there else at - t)
            if x is None:
                return
            rows.append(self._row(waiting.pop(), x))

    def _result(self, table: np.ndarray, watched: list[WatchedEvent]) -> Result:
        stepper = self.stepper
        variables = len(stepper.variables)
        columns = table.T
        return Result(
            t=columns[0], y=columns[1:1 + variables], names=list(stepper.variables),
            energy=columns[1 + variables],
            invariants=dict(zip(self.invariants, columns[2 + variables:])),
            status=self.status, message=self.message, steps=self.done,
            method=stepper.description.method,
            t_events=[np.array(each.times) for each in watched] if watched else None,
            y_events=[np.array(each.states).reshape(len(each.states), variables)
                      for each in watched] if watched else None)


class Curve:
    """The trajectory at any time between: by steps from the row before, and a shorter one."""

    def __init__(self, stepper: Stepper, first: np.ndarray, begin: float, h: float,
                 result: Result):
        self.stepper, self.begin, self.h = stepper.copy(), begin, h
        self.times = result.t
        self.rows = result.y
        self.first = first

    def __call__(self, t: Any) -> np.ndarray:
        """y there: shape (variables,) for a number, (variables, count) for an array of times.

        Raises ValueError outside the run, StepError where a step fails.
        """
        if np.ndim(t) == 0:
            return self._at(float(t))
        return np.array([self._at(float(each)) for each in np.ravel(t)]).T

    def _at(self, t: float) -> np.ndarray:
        ahead = math.copysign(1.0, self.h)
        if not ahead * self.times[0] <= ahead * t <= ahead * self.times[-1]:
            raise ValueError(f"the run goes from {self.times[0]} to {self.times[-1]}")
        row = int(np.searchsorted(ahead * self.times, ahead * t, side="right")) - 1
        at = float(self.times[row])
        variables = len(self.stepper.variables)
        state = self.first.copy()
        state[:variables] = self.rows[:, row]
        if self.stepper.description.has_time:
            state[-1] = at
        self.stepper.reset()
        for _ in range(math.floor((t - at) / self.h + 1e-9)):
            self.stepper.step(state, self.h)
            at += self.h
        if abs(t - at) > 1e-9 * abs(self.h):
            self.stepper.step(state, t - at)
        return state[:variables].copy()


class Progress:
    """A line on standard error that says how far a run is, where that is a terminal."""

    def __init__(self, steps: int):
        self.steps, self.began, self.said = steps, time.monotonic(), 0.0
        self.is_shown = False

    def show(self, done: int, _seconds: float) -> None:
        now = time.monotonic()
        if now - self.began < 1 or now - self.said < 0.2 or not sys.stderr.isatty():
            return
        self.said, self.is_shown = now, True
        share = min(1.0, done / max(1, self.steps))
        left = (now - self.began) * (1 / share - 1) if share else math.inf
        print(f"\r{share:6.1%} of {self.steps} steps, {left:.0f} s left ", end="",
              file=sys.stderr, flush=True)

    def close(self) -> None:
        if self.is_shown:
            print("\r\x1b[K", end="", file=sys.stderr, flush=True)
