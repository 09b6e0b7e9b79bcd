/** Steps at the edge of a case: that begin where they end, that turn without friction, that leave by the other side. */
import { describe, expect, it } from 'vitest'
import { lawOf } from '../../src/physics/law.ts'
import { rk4 } from '../../src/physics/integrators/rk4.ts'
import { Motion } from '../../src/physics/motion.ts'
import { advance } from '../../src/physics/step.ts'
import { located } from '../../src/physics/stopping/located.ts'
import { straight } from '../../src/physics/track.ts'
import { simulate, traceFrame } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import { last } from './truth.ts'

describe('the search for a stop', () => {
  it('asks for as many accelerations as it needs, and no more', () => {
    const braking: Experiment = {
      scene: 'ramp',
      parameters: { angle: 0, muStatic: 0.5, muKinetic: 0.5, speed: 1 },
      integrator: 'velocity-verlet',
      stopping: 'located',
      frames: { kind: 'steady', fps: 10 },
      duration: 0.3,
    }
    // The first; one at the end of each of three steps, the third of which goes too far; one at the end of the step that is
    // cut, since a speed that falls evenly is met at the first try; and one that shows that the block stays.
    expect(simulate(braking).evaluations).toBe(1 + 3 + 1 + 1)
  })

  it('begins with half of a step that ends beyond a turn and begins at one', () => {
    // ω = 3.098/s: in a second hardly half a swing, of which the method makes a little more.
    const released: Experiment = {
      scene: 'spring',
      parameters: { angle: 0, stiffness: 9.6, position: 1, muStatic: 0.01, muKinetic: 0.01 },
      integrator: 'rk4',
      stopping: 'located',
      frames: { kind: 'steady', fps: 1 },
      duration: 1,
    }
    const [step] = traceFrame(released, 1)
    const [first] = step!.stretches
    const lengths = first!.tries.map(({ dt }) => dt)
    expect(lengths.slice(0, 2)).toEqual([1, 0.5])
    expect(first!.ends).toBe('stop')
  })
})

describe('a block that its method flings out of the pipe', () => {
  it('leaves by either lip, whichever side it slid to at first', () => {
    const sides = new Set<boolean>()
    for (let i = 0; i < 20; i++) {
      const position = (i % 2 === 0 ? 1 : -1) * (1 + 0.1 * i)
      const { outcome, s } = simulate({
        scene: 'half-pipe',
        parameters: { radius: 2, position, speed: 0, muStatic: 0, muKinetic: 0 },
        integrator: 'explicit-euler',
        stopping: 'located',
        frames: { kind: 'steady', fps: 20 },
        duration: 60,
      })
      expect(outcome.kind, `from ${position} m`).toBe('left-the-track')
      expect(Math.abs(last(s))).toBe(Math.PI)
      sides.add(last(s) > 0 === position > 0)
    }
    expect(sides.size).toBe(2)
  })
})

describe('without friction', () => {
  it('a block on the level that has no speed is at rest from the first', () => {
    const { outcome } = simulate({
      scene: 'ramp',
      parameters: { angle: 0, muStatic: 0, muKinetic: 0, speed: 0 },
      integrator: 'velocity-verlet',
      stopping: 'located',
      duration: 1,
    })
    expect(outcome).toEqual({ kind: 'at-rest', time: 0 })
  })

  it('a ball without drag that is thrown up turns in the middle of a step, whatever the stopping rule', () => {
    const thrown: Experiment = {
      scene: 'fall',
      parameters: { speed: -4 },
      integrator: 'explicit-euler',
      frames: { kind: 'steady', fps: 7 },
      duration: 2,
    }
    const naive = simulate({ ...thrown, stopping: 'naive' })
    for (const stopping of ['clamped', 'located'] as const) {
      const { s, v, evaluations } = simulate({ ...thrown, stopping })
      expect({ s, v, evaluations }).toEqual({
        s: naive.s,
        v: naive.v,
        evaluations: naive.evaluations,
      })
    }
  })
})

describe('friction that takes the sign of each speed it is asked about', () => {
  it.each([1, -1])('is none at a speed of 0: a first step with the slope to side %d', (side) => {
    const { v } = simulate({
      scene: 'half-pipe',
      parameters: { radius: 2, position: -side, speed: 0, muStatic: 0.1, muKinetic: 0.1 },
      integrator: 'explicit-euler',
      stopping: 'naive',
      frames: { kind: 'steady', fps: 10 },
      duration: 0.1,
    })
    // g sin(s/R) Δt, and nothing of μ.
    expect(last(v)).toBeCloseTo(side * 9.81 * Math.sin(0.5) * 0.1, 14)
  })
})

describe('a block released at the very end of a track', () => {
  it('that goes downhill beyond leaves it there and then', () => {
    const motion = new Motion(lawOf([straight(30, 0)], { gravity: 9.81 }), 0, 0, true)
    motion.dt = 0.1
    advance(motion, rk4, located)
    expect(motion).toMatchObject({ s: 0, v: 0, outcome: 'left-the-track', elapsed: 0, dt: 0.1 })
  })

  it('that goes uphill beyond slides back', () => {
    const motion = new Motion(lawOf([straight(-30, 0)], { gravity: 9.81 }), 0, 0, true)
    motion.dt = 0.1
    advance(motion, rk4, located)
    expect(motion.moving).toBe(true)
    expect(motion.v).toBeCloseTo(-0.4905, 12)
    expect(motion.elapsed).toBe(0.1)
  })
})
