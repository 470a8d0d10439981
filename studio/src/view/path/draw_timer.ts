// Time of the graphics card for the complete path; measured by a fence, some frames later.

const POLL_MS = 4;
// Delay of a fence even if drawing takes no time.
const FENCE_DELAY_MS = 12;

export class Timer {
  /** null: not known yet. */
  cost_ms: number | null = null;
  private begun_ms = 0;
  private round = 0;

  constructor(private readonly gl: WebGL2RenderingContext) {}

  forget(): void {
    this.cost_ms = null;
    ++this.round;
  }

  begin(): void {
    this.begun_ms = performance.now();
  }

  /** `share`: factor from the drawn part to the complete path. */
  end(share: number): void {
    const fence = this.gl.fenceSync(this.gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (!fence) return;
    this.gl.flush();
    this.await(fence, ++this.round, this.begun_ms, share);
  }

  private await(fence: WebGLSync, round: number, begun_ms: number, share: number): void {
    const { gl } = this;
    if (gl.isContextLost()) return;
    if (gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED) {
      setTimeout(() => this.await(fence, round, begun_ms, share), POLL_MS);
      return;
    }
    gl.deleteSync(fence);
    if (round === this.round) this.cost_ms = share * Math.max(0, performance.now() - begun_ms - FENCE_DELAY_MS);
  }
}
