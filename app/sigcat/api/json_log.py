"""The log: a line of JSON for each record, on standard error."""

import json
import logging
import sys

TIME = "%Y-%m-%dT%H:%M:%S%z"
_LOGGERS = ("sigcat", "uvicorn", "asyncio")


class _Lines(logging.Formatter):
    """One line of JSON for each record."""

    def format(self, record: logging.LogRecord) -> str:
        """The line."""
        time = self.formatTime(record, TIME)
        record_fields = {"time": time, "level": record.levelname.lower(), "logger": record.name}
        if record.exc_info:
            record_fields["trace"] = self.formatException(record.exc_info)
        return json.dumps({**record_fields, "message": record.getMessage()})


def log_as_json(level: int) -> None:
    """Send what sigcat and its server log to standard error, a line of JSON each."""
    handler = logging.StreamHandler(sys.stderr)
    handler.setFormatter(_Lines())
    for name in _LOGGERS:
        logger = logging.getLogger(name)
        logger.handlers, logger.propagate = [handler], False
        logger.setLevel(level if name == "sigcat" else logging.WARNING)
    logging.getLogger("uvicorn.access").disabled = True  # requests are logged by the service, each once
