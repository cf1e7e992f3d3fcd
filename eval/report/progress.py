# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""How far a run is: a bar on a terminal, now and then a line elsewhere."""
import sys
import time

LINE_EVERY = 30.0  # s, between lines where there is no terminal
BAR_WIDTH = 30


def clock_text(seconds):
    """"0:42", "12:05", "1:02:03"."""
    minutes, seconds = divmod(int(seconds + 0.5), 60)
    hours, minutes = divmod(minutes, 60)
    return "%d:%02d:%02d" % (hours, minutes, seconds) if hours else "%d:%02d" % (minutes, seconds)


class Progress:
    """Work is counted in estimated seconds; what remains follows from how long the work so far took."""

    def __init__(self, total, stream=sys.stderr, clock=time.monotonic):
        self.total, self.stream, self.clock = max(total, 1e-9), stream, clock
        self.done, self.text = 0.0, ""
        self.start = clock()
        self.last_line = self.start - LINE_EVERY

    def say(self, text):
        """What is worked on now."""
        self.text = text
        self.show()

    def advance(self, work):
        """So much more is done."""
        self.done += work
        self.show()

    def status(self):
        """"37 %, 1:20 elapsed, about 2:10 left"."""
        share, elapsed = min(self.done / self.total, 1.0), self.clock() - self.start
        left = "about %s left" % clock_text(elapsed * (1 - share) / share) if share > 0.01 else "estimating"
        return share, "%3.0f %%, %s elapsed, %s" % (100 * share, clock_text(elapsed), left)

    def show(self):
        share, status = self.status()
        if self.stream.isatty():
            full = int(BAR_WIDTH * share + 0.5)
            bar = "#" * full + "." * (BAR_WIDTH - full)
            self.stream.write("\r[%s] %s  %s\033[K" % (bar, status, self.text))
        elif self.clock() - self.last_line >= LINE_EVERY:
            self.last_line = self.clock()
            self.stream.write("%s  %s\n" % (status, self.text))
        self.stream.flush()

    def note(self, text):
        """A line that stays."""
        self.stream.write(("\r\033[K" if self.stream.isatty() else "") + text + "\n")
        self.stream.flush()

    def finish(self):
        """Ends the bar's line."""
        self.note("100 %%, %s elapsed" % clock_text(self.clock() - self.start))
