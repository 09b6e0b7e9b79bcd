import { describe, expect, it } from 'vitest'
import { scenes } from '../../src/physics/index.ts'
import type { ExactMotion, Scene } from '../../src/physics/index.ts'
import { bends, relative, truth } from './truth.ts'

// Rounding alone: an ulp of the angle ωt, which reaches 140 rad, is 3e-14 of a swing.
const ROUNDING = 1e-13

describe.each(truth)('$name', ({ experiment, duration, s, v, stops, outcome }) => {
  const scene: Scene = scenes.find(({ id }) => id === experiment.scene)!
  const motion = scene.exact(experiment.parameters as Record<string, number>)
  const speed = (t: number) => motion(t, { s: 0, v: 0 }).v

  it('ends in the true state', () => {
    const end = motion(duration, { s: 0, v: 0 })
    expect(relative(end.s - s, s)).toBeLessThanOrEqual(ROUNDING)
    expect(relative(end.v - v, v)).toBeLessThanOrEqual(ROUNDING)
  })

  it('is at rest in the end where the truth is', () => {
    expect(speed(duration) === 0).toBe(outcome === 'at-rest')
  })

  it('stops when the truth does', () => {
    for (const stop of stops) {
      const before = Math.sign(speed(stop - 1e-13 * (1 + stop)))
      const after = Math.sign(speed(stop + 1e-13 * (1 + stop)))
      expect(before).not.toBe(0)
      expect(after).not.toBe(before)
    }
  })

  it('stops as often as the truth does', () => {
    // The truth lists the first twelve. Half-swings last 0.07 s and more.
    expect(Math.min(12, countStops(motion, duration))).toBe(stops.length)
  })
})

describe.each(bends)('through a bend, $name', (each) => {
  const { experiment, duration, s, v, condition, outcome, time } = each
  const scene: Scene = scenes.find(({ id }) => id === experiment.scene)!
  const motion = scene.exact(experiment.parameters as Record<string, number>)
  const at = (t: number) => motion(t, { s: 0, v: 0 })

  it('ends in the true state', () => {
    const end = at(duration)
    expect(Math.abs(end.s - s)).toBeLessThanOrEqual(
      1e-11 * Math.max(1, Math.abs(s)) + 100 * condition,
    )
    // The speed is as well known as the place: no rate in these motions exceeds 20/s, and no condition 2e-14 m.
    expect(relative(end.v - v, v)).toBeLessThanOrEqual(1e-11)
  })

  it('moves, rests or has left the track as in truth', () => {
    const later = at(duration + 1)
    if (outcome === 'moving') {
      expect(at(duration).v).not.toBe(0)
      expect(later).not.toEqual(at(duration))
    } else {
      expect(later).toEqual(at(duration))
      expect(later.v === 0).toBe(outcome === 'at-rest')
      // The time is known to rounding, magnified where the block arrives slowly.
      const lastMove = time! - 1e-11
      expect(at(lastMove)).not.toEqual(later)
      expect(at(time! + 1e-11)).toEqual(later)
    }
  })
})

function countStops(motion: ExactMotion, duration: number): number {
  const state = { s: 0, v: 0 }
  let count = 0
  let sign = 0
  for (let i = 0; i <= 10000; i++) {
    const next = Math.sign(motion((duration * i) / 10000, state).v)
    if (next !== sign && sign !== 0) count++
    sign = next
  }
  return count
}
