import { withoutRounding } from '../../measure/index.ts'
import type { Spread } from '../../measure/index.ts'
import { fixed, raw, seconds } from '../../chart/numbers.ts'

const words = {
  moving: 'moving',
  'at-rest': 'at rest',
  'left-the-track': 'left the track',
  diverged: 'diverged',
}

/** How far apart runs end, for people. */
export interface SpreadText {
  readonly value: string
  /** What else is to be said of it; empty where nothing is. */
  readonly remark: string
  readonly title: string
  /** The frames make no difference but for rounding. */
  readonly exact: boolean
}

/**
 * A spread in words: “0.23 m”, “62 ms (left the track at 0.39 to 0.46 s)”, “different outcomes (moving, left the
 * track)”.
 *
 * @param lengthText writes a distance [m]
 */
export function spreadText(spread: Spread, lengthText: (length: number) => string): SpreadText {
  const { outcomes, agree, distance, earliest, latest, scale } = spread
  const exact = false
  if (spread.abandoned)
    return {
      value: 'tolerance not met',
      remark: '',
      exact,
      title: 'Some run found no step short enough for its tolerance',
    }
  if (!agree) {
    const remark = outcomes.map((kind) => words[kind]).join(', ')
    return {
      value: 'different outcomes',
      remark,
      exact,
      title: 'The runs end differently, so no distance says how far apart they are',
    }
  }
  if (outcomes.includes('diverged'))
    return { value: 'without bound', remark: 'all diverged', exact, title: 'Every run diverges' }
  const size = withoutRounding(distance, scale)
  const title = `Largest − smallest final position: ${raw(distance)} m`
  const [length = '', rounding = ''] = lengthText(size).split(/ \((.*)\)/)
  if (Number.isNaN(latest)) return { value: length, remark: rounding, exact: size === 0, title }
  const apart = withoutRounding(latest - earliest, Math.max(1, latest))
  const [first, last] = [fixed(earliest, 2), fixed(latest, 2)]
  return {
    value: apart === 0 ? length : seconds(apart),
    remark: `left the track at ${first === last ? '' : `${first} to `}${last}\u202fs`,
    exact: apart === 0 && size === 0,
    title: `${title}; latest − earliest time of leaving the track: ${raw(latest - earliest)} s`,
  }
}
