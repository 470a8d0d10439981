// Cuts a stream of bytes into the engine's frames (docs/studio.md). Each frame gets separate memory, so that
// its columns are at multiples of 8; each byte is copied once.

import { InvalidMessage } from "./message";

const SIZE_BYTES = 4;
const MIN_FRAME_BYTES = 8;

export class FrameSplitter {
  private readonly size = new Uint8Array(SIZE_BYTES);
  private frame: Uint8Array<ArrayBuffer> | null = null;
  private filled = 0;

  /** Adds received bytes; passes on each complete frame. */
  push(bytes: Uint8Array, onFrame: (frame: Uint8Array<ArrayBuffer>) => void): void {
    for (let at = 0; at < bytes.length; ) {
      at += this.fill(bytes.subarray(at));
      if (!this.frame || this.filled < this.frame.length) continue;
      const whole = this.frame;
      [this.frame, this.filled] = [null, 0];
      onFrame(whole);
    }
  }

  /** Returns the number of bytes that belong to the part being filled. */
  private fill(bytes: Uint8Array): number {
    const into = this.frame ?? this.size;
    const count = Math.min(bytes.length, into.length - this.filled);
    into.set(bytes.subarray(0, count), this.filled);
    this.filled += count;
    if (!this.frame && this.filled === SIZE_BYTES) this.begin();
    return count;
  }

  private begin(): void {
    const length = new DataView(this.size.buffer).getUint32(0, true);
    if (length < MIN_FRAME_BYTES) throw new InvalidMessage(`a message of ${length} bytes is not valid`);
    this.frame = new Uint8Array(length);
    this.frame.set(this.size);
  }
}
