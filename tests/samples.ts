/** How much of a test's samples to take: all of them, or the part that SAMPLES says, as `npm run mutate` does. */
const PART = Number(process.env.SAMPLES ?? 1)

/** A count of samples, or the part of it that this run asks for. */
export function samples(count: number): number {
  return Math.ceil(count * PART)
}
