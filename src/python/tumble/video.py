"""Videos of frames, encoded by the program ffmpeg."""

from __future__ import annotations

import os
from types import TracebackType
from typing import Any

import numpy.typing as npt

from tumble import _tumble
from tumble.rendering import checked_pixels
from tumble.shapes import number


class Video:
    """A video of frames: .mp4 (H.264), .webm (VP9), .gif or .apng.

    >>> with tumble.Video("fall.mp4", fps=30) as video:
    ...     for _ in range(60):
    ...         world.step(2)
    ...         video.write(world.render(center=(0, 3), view_height=8))

    The file appears when the video is closed; after an exception in the block there is none. The same frames give the
    same bytes. Raises RenderError if ffmpeg is missing or fails, and FileError if the file cannot be written.
    """

    def __init__(self, path: str | os.PathLike[str], fps: float = 60.0) -> None:
        """`fps` is the number of frames a second. The size is that of the first frame, even for .mp4 and .webm."""
        self._path, self._fps = os.fspath(path), number(fps, "fps")
        if not 0.0 < self._fps < float("inf"):
            raise ValueError(f"fps must be finite and above 0, got {fps!r}")
        _tumble.require_video_name(self._path)
        self._writer: _tumble.VideoWriter | None = None
        self._is_closed = False

    def write(self, pixels: npt.NDArray[Any]) -> None:
        """Appends a frame, [height, width, 3 or 4] of uint8, as `render` makes it."""
        if self._is_closed:
            raise ValueError(f"the video {self._path} is closed")
        frame = checked_pixels(pixels)
        if self._writer is None:
            self._writer = _tumble.VideoWriter(self._path, frame.shape[1], frame.shape[0], self._fps)
        self._writer.write(frame)

    def close(self) -> None:
        """Finishes the file. A video without a frame makes none."""
        writer, self._writer, self._is_closed = self._writer, None, True
        if writer is not None:
            writer.finish()

    def __enter__(self) -> Video:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        if kind is not None:
            self._writer = None  # ends ffmpeg, which removes what it has written
        self.close()

    def __repr__(self) -> str:
        return f"<Video {self._path!r}, {self._fps:g} fps{', closed' if self._is_closed else ''}>"
