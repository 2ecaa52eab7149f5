"""The exceptions of scb. The text of each is one sentence: what is wrong, where, and what to do."""


class Error(Exception):
    """All exceptions of scb."""


class InputError(Error, ValueError):
    """Bad data from outside: an array, a number, a name, a file."""


class OutputError(Error, OSError):
    """A file cannot be written."""


class GlError(Error, RuntimeError):
    """There is no usable OpenGL here."""


class DrawError(Error, RuntimeError):
    """OpenGL is there and cannot draw: out of memory, as a rule."""


class MeshReaderError(Error, RuntimeError):
    """The process that reads mesh files cannot do its work."""


class SystemLimitError(Error, OSError):
    """The system has no more threads or processes to give."""
