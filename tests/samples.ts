/** Whether this is `npm run test:long`, which takes every sample and every combination. */
export const isLong = process.env.TEST_LONG === 'yes'

/** How much of a test's samples to take: all of them, or the part that SAMPLES says, as `npm run mutate` does. */
const PART = Number(process.env.SAMPLES ?? 1)

/** A count of samples: `count`, or the part of it that this run asks for, or `long` in `npm run test:long`. */
export function samples(count: number, long = count): number {
  return isLong ? long : Math.ceil(count * PART)
}

/** Of cases that find the same faults the ones at these places, or all of them in `npm run test:long`. */
export function some<T>(cases: readonly T[], ...places: number[]): readonly T[] {
  return isLong ? cases : places.map((place) => cases[place]!)
}
