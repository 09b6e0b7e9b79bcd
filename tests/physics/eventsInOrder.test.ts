import { describe, expect, it } from 'vitest'
import { exactMotion, simulate } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import { samples } from '../samples.ts'
import { Chance, hitches, meetings, meetingsInOneStep } from './generated.ts'
import type { Meeting } from './generated.ts'

interface Numbers {
  angle: number
  length: number
  bendRadius: number
}

/** Whether the true block meets what it is named after within the first frame, seen at a hundred instants of it. */
function meets(experiment: Experiment, meeting: Meeting, frame: number): boolean {
  const { angle, length, bendRadius } = experiment.parameters as unknown as Numbers
  const foot = length + (bendRadius * angle * Math.PI) / 180
  const truth = exactMotion(experiment)
  const states = Array.from({ length: 101 }, (_, i) => truth((i / 100) * frame, { s: 0, v: 0 }))
  const end = states.at(-1)!
  const start = states[0]!
  const highest = Math.min(...states.map(({ s }) => s))
  if (meeting === 'foot, then stop') return start.s < foot && end.s > foot && end.v === 0
  if (meeting === 'joint, then foot') return start.s < length && end.s > foot
  const before = meeting === 'turn, then joint' ? start.s < length : start.s > length
  return before && start.v < 0 && highest < length && end.s > length && end.v > 0
}

describe.each(meetings)('in one step of rk8: %s', (meeting) => {
  it('the block is where it is in truth at the end of every frame', () => {
    let met = 0
    const cases = meetingsInOneStep(meeting, samples(400), 20260105)
    for (const experiment of cases) {
      const run = simulate({ ...experiment, integrator: 'rk8' })
      const truth = exactMotion(experiment)
      const where = JSON.stringify(experiment)
      const { bendRadius } = experiment.parameters as unknown as Numbers
      const frame = run.time[1]!
      const z = frame * Math.sqrt(9.81 / bendRadius)
      // A step of z = ω dt is off by at most 1.6e-4 z⁹ in units of R and ω R (see lipVerdicts.ts), at these slow speeds. Taken
      // with the wrong friction or the wrong law for a tenth of itself it would be off by a hundred times this.
      const bound = 4 * 1.6e-4 * z ** 9 + 1e-13
      for (let row = 1; row <= run.frames; row++) {
        const at = truth(run.time[row]!, { s: 0, v: 0 })
        expect(Math.abs(run.s[row]! - at.s) / bendRadius, where).toBeLessThanOrEqual(bound)
        const speed = bendRadius / Math.sqrt(bendRadius / 9.81)
        expect(Math.abs(run.v[row]! - at.v) / speed, where).toBeLessThanOrEqual(bound)
      }
      met += Number(meets(experiment, meeting, frame))
    }
    // So that the cases are what they are named after.
    expect(met).toBeGreaterThan(0.5 * cases.length)
  })
})

it('hitches over stops and joints of moderate bends leave rk8 where the block is in truth', () => {
  const chance = new Chance(20260106)
  let rested = 0
  for (let i = 0; i < samples(1000); i++) {
    const bendRadius = chance.scale(1, 4)
    const mu = chance.between(0.1, 0.6)
    const longest = Math.sqrt(bendRadius / 9.81)
    const experiment: Experiment = {
      scene: 'run-out',
      parameters: {
        ...{ angle: chance.between(10, 80), length: chance.between(0.2, 2), bendRadius },
        ...{ muStatic: mu, muKinetic: mu, speed: chance.between(-3, 3) },
      },
      // Half to one of √(R/g).
      frames: hitches(chance, 0.5 * longest, longest),
      duration: 4,
    }
    const run = simulate({ ...experiment, integrator: 'rk8' })
    const truth = exactMotion(experiment)
    const where = JSON.stringify(experiment)
    let worst = 0
    for (let row = 1; row <= run.frames; row++) {
      const at = truth(run.time[row]!, { s: 0, v: 0 })
      worst = Math.max(worst, Math.abs(run.s[row]! - at.s))
    }
    // A hitch of ω dt = 1 leaves 1.6e-4 R; a block that comes down at 5 m/s bends by up to five times as much in it, for which
    // a step as long as that is coarse: what is asked for here is a centimetre.
    expect(worst, where).toBeLessThanOrEqual(0.01)
    const end = truth(4, { s: 0, v: 0 })
    // A centimetre off, it may stop so much sooner or later.
    if (end.v === 0 && truth(3.8, { s: 0, v: 0 }).v === 0) {
      expect(run.outcome.kind, where).toBe('at-rest')
      rested++
    } else if (Math.abs(end.v) > 0.5) expect(run.outcome.kind, where).toBe('moving')
  }
  expect(rested).toBeGreaterThan(samples(200))
})
