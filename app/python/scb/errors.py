"""The exceptions of scb. The text of each is one sentence: what is wrong, where, and what to do."""


class Error(Exception):
    """All exceptions of scb."""


class InputError(Error, ValueError):
    """Bad data from outside: an array, a number, a name, a file."""


class OutputError(Error, OSError):
    """A file cannot be written."""


class GlError(Error, RuntimeError):
    """OpenGL is missing or cannot be used."""


class DrawError(Error, RuntimeError):
    """OpenGL is present but cannot draw; usually, memory ran out."""


class MeshReaderError(Error, RuntimeError):
    """The process that reads mesh files cannot do its work."""


class SystemLimitError(Error, OSError):
    """The system cannot create more threads or processes."""
