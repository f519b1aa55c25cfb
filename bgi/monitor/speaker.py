"""The PC's speaker: a square wave, on or off, whose pitch changes without a gap.

The timer chip counted 1,193,180 times a second and moved the speaker's membrane each time a certain
number of counts had passed: a whole number, so that pitches are not exact, here as then. SDL asks
for samples when it needs them (`fill`), and the wave goes on where it was.
"""

from array import array

from bgi.memory.sdl import pygame, quietly

CLOCK_HERTZ = 1_193_180  # of the timer chip
RATE = 44_100  # samples a second
CHUNK = 512  # samples that are asked for at a time: a change is heard within 12 ms
LOUDNESS = 4000  # of 32767: such a speaker was not loud
MAX_HERTZ = 20_000  # higher tones nobody hears; as samples they would be heard as lower ones


class Speaker:
    """Silent until the first sound; where there is no sound card it stays so."""

    def __init__(self) -> None:
        self._step = 0.0  # what a sample adds to the phase
        self._phase = 0.0  # the part of a wave that has been played
        self._device: object = None
        self._tried = False

    def sound(self, hertz: int) -> None:
        """Play a pitch until told otherwise; 0 is silence."""
        counts = CLOCK_HERTZ // hertz if hertz > 0 else 0
        frequency = CLOCK_HERTZ / counts if counts else 0.0
        self._step = frequency / RATE if frequency <= MAX_HERTZ else 0.0
        if self._step and not self._tried:
            self._tried = True
            with quietly():
                self._device = self._open()

    def fill(self, samples: memoryview) -> None:
        """Write the next samples, numbers of 16 bits."""
        step, phase, count = self._step, self._phase, len(samples)
        if step:
            phases = ((phase + step * number) % 1.0 for number in range(count))
            wave = array("h", [LOUDNESS if part < 0.5 else -LOUDNESS for part in phases])
        else:
            wave = array("h", bytes(2 * count))
        samples[:] = memoryview(wave)
        self._phase = (phase + step * count) % 1.0

    def _open(self) -> object:
        """Start the sound card; None if there is none. It is never paused: that could deadlock."""
        from pygame import _sdl2  # late, as sound is rare
        from pygame._sdl2 import audio

        try:
            _sdl2.init_subsystem(_sdl2.INIT_AUDIO)
            device = audio.AudioDevice(
                devicename=audio.get_audio_device_names(False)[0],
                iscapture=False,
                frequency=RATE,
                audioformat=audio.AUDIO_S16,
                numchannels=1,
                chunksize=CHUNK,
                allowed_changes=0,
                callback=lambda device, memory: self.fill(memoryview(memory).cast("h")),
            )
        except (pygame.error, _sdl2.error, IndexError):
            return None
        device.pause(0)
        return device
