import { describe, expect, it } from 'vitest'
import { scenes } from '../../src/physics/index.ts'
import type { ExactMotion, Scene } from '../../src/physics/index.ts'
import { relative, truth } from './truth.ts'

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
