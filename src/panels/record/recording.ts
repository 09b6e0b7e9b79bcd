/** Calls back once, with a timestamp [ms], when the next frame begins; the answer calls that off. */
export type FrameSource = (callback: (timestamp: number) => void) => () => void

/** The frames of this browser window. */
export const animationFrames: FrameSource = (callback) => {
  const request = requestAnimationFrame(callback)
  return () => cancelAnimationFrame(request)
}

interface Recording {
  readonly source: FrameSource
  /** How long to record [s]. */
  readonly length: number
  /** Told at every frame how much of it is done, from 0 to 1. */
  readonly progress: (part: number) => void
  /** Told once, at the end: when each frame began [ms]. */
  readonly done: (timestamps: number[]) => void
}

/** Takes down when frames begin, for as long as asked. The answer calls it off. */
export function record({ source, length, progress, done }: Recording): () => void {
  const timestamps: number[] = []
  const next = (timestamp: number): void => {
    timestamps.push(timestamp)
    const part = (timestamp - timestamps[0]!) / 1000 / length
    if (part >= 1) done(timestamps)
    else {
      cancel = source(next)
      progress(part)
    }
  }
  let cancel = source(next)
  return () => cancel()
}
