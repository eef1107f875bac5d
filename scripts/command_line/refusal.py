# SPDX-License-Identifier: BSD-3-Clause
"""Bad input ends a program with one line and status 2."""
import contextlib
import pathlib
import signal
import sys


class Refusal(Exception):
    """What is wrong, in one line."""


@contextlib.contextmanager
def expecting(what, path):
    """Refuses content that lacks something or has something of another kind."""
    try:
        yield
    except (AttributeError, IndexError, KeyError, TypeError, ValueError) as error:
        detail = f", there is no {error}" if isinstance(error, KeyError) else ""
        raise Refusal(f"{path}: expected {what}{detail}") from None


def read_text(path):
    try:
        return pathlib.Path(path).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        reason = getattr(error, "strerror", None) or "it is no text"
        raise Refusal(f"{path}: the file cannot be read: {reason}") from None


def say(program, text):
    print(f"{program}: {text}", file=sys.stderr, flush=True)


def interrupt(*_):
    raise KeyboardInterrupt


def status_of(program, work):
    """The exit status of work(), which may refuse; SIGTERM and SIGHUP end it as Ctrl-C does."""
    for number in (signal.SIGTERM, signal.SIGHUP):
        if signal.getsignal(number) == signal.SIG_DFL:  # nohup ignores SIGHUP
            signal.signal(number, interrupt)
    try:
        return work() or 0
    except Refusal as refusal:
        say(program, " ".join(str(refusal).split()))
        return 2
    except KeyboardInterrupt:
        return 130
