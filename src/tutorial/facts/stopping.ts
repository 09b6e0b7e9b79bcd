import { simulate } from '../../physics/index.ts'
import { count, metres, place } from '../../chart/numbers.ts'
import { apart, at, end, kick, paperStep, takeHome } from './experiments.ts'
import type { Facts } from './fact.ts'

/** The block that does not rest, from two seconds after the kick to three, at 60 fps. */
function trembling() {
  const { s, v } = simulate({ ...kick, ...paperStep, stopping: 'naive', duration: 3 })
  return { s: s.subarray(120), v: v.subarray(120) }
}

function turns(): number {
  const { v } = trembling()
  return v.subarray(1).filter((speed, i) => speed * v[i]! < 0).length
}

const clamped = (fps: number) => -end(at(fps, { ...kick, ...paperStep }))

/** A block that is kicked up a slope and stays there. */
export const stopping = {
  chatterTurns: { value: turns, show: count },
  chatterCreep: { value: () => trembling().s.at(-1)! - trembling().s[0]!, show: metres },
  clamped10: { value: () => clamped(10), show: place },
  clamped30: { value: () => clamped(30), show: place },
  clamped120: { value: () => clamped(120), show: place },
  clampedThreeSpread: {
    value: () => apart({ ...kick, ...paperStep }, [10, 30, 120]),
    show: metres,
  },
  clampedVerletSpread: {
    value: () => apart({ ...kick, ...takeHome, stopping: 'clamped' }),
    show: metres,
  },
  clampedEulerSpread: { value: () => apart({ ...kick, ...paperStep }), show: metres },
  locatedVerletSpread: { value: () => apart({ ...kick, ...takeHome }), show: metres },
  locatedEulerSpread: {
    value: () => apart({ ...kick, ...paperStep, stopping: 'located' }),
    show: metres,
  },
} as const satisfies Facts
