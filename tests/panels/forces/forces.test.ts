import { readFileSync } from 'node:fs'
import { resolve } from 'node:path'
import { describe, expect, test } from 'vitest'
import { dot, forcesAt, length, simulate } from '../../../src/physics/index.ts'
import type { Experiment } from '../../../src/physics/index.ts'
import {
  forcesOf,
  largestOf,
  arrowNames,
  lookedAt,
  pictureForces,
} from '../../../src/panels/forces/forcesPicture.ts'
import { frictionText, quantity } from '../../../src/panels/forces/forcesPanel.ts'
import type { LabView } from '../../../src/lab/labView.ts'
import { opening } from '../../../src/lab/state/opening.ts'
import { Simulation } from '../../../src/lab/state/simulation.ts'
import { changed } from '../../../src/lab/state/change.ts'
import type { LabState } from '../../../src/lab/state/state.ts'

/** A lab that only looks. */
function lab(state: LabState, time: number, selected = 0): LabView {
  const simulated = new Simulation().run(state)
  return { simulated, selected, playback: { time } } as unknown as LabView
}

const moving: Experiment[] = [
  { scene: 'fall', parameters: { drag: 0.4, mass: 3 } },
  { scene: 'ramp', parameters: { mass: 2.5, angle: 37, speed: -3 } },
  { scene: 'run-out', parameters: { mass: 1.3, angle: 50 } },
  { scene: 'half-pipe', parameters: { mass: 0.7, muKinetic: 0.3, muStatic: 0.4 } },
  { scene: 'spring', parameters: { mass: 4, stiffness: 90, position: 1 } },
  // The naive rule has no friction at all in the step that begins with v = 0.
  { scene: 'ramp', parameters: { mass: 2, angle: 40 }, stopping: 'naive' },
  { scene: 'ramp', parameters: { angle: 5 }, stopping: 'naive' },
]

describe.each(moving)('in $scene $stopping', (given) => {
  const experiment: Experiment = { stopping: 'clamped', ...given, integrator: 'explicit-euler' }
  const trajectory = simulate(experiment)
  const { time, s, v } = trajectory

  test('the sum along the track is what moves the block in the step that follows', () => {
    let steps = 0
    for (let row = 0; row < trajectory.frames; row++) {
      const forces = forcesOf({ trajectory, row })!
      const change = (v[row + 1]! - v[row]!) / (time[row + 1]! - time[row]!)
      const { mass } = trajectory.experiment.parameters
      // A step that ends at rest is shorter than its frame; one across a joint is the next piece's.
      if (v[row + 1] === 0 || forces.vectors.frictionKind === 'held') continue
      expect(dot(forces.vectors.sum, forces.vectors.along)).toBeCloseTo(mass! * change, 6)
      steps++
    }
    expect(steps).toBeGreaterThan(10)
  })

  test('they are those of physics, and none is larger than the largest', () => {
    const { force, speed } = largestOf(trajectory)
    for (let row = 0; row <= trajectory.frames; row++) {
      const { vectors, velocity } = forcesOf({ trajectory, row })!
      if (v[row] !== 0 || experiment.stopping !== 'naive')
        expect(vectors).toEqual(forcesAt(experiment, { s: s[row]!, v: v[row]! }))
      expect(dot(velocity, vectors.along)).toBeCloseTo(v[row]!, 12)
      expect(length(velocity)).toBeLessThanOrEqual(speed * (1 + 1e-12))
      for (const each of [vectors.gravity, vectors.normal, vectors.friction, vectors.sum])
        expect(length(each)).toBeLessThan(1.02 * force)
    }
  })
})

test('a block at rest is held by as much friction as it takes, not by μN', () => {
  const { trajectory } = new Simulation().run(opening).runners[0]!
  const forces = forcesOf({ trajectory, row: trajectory.frames })!
  expect(forces.vectors.frictionKind).toBe('held')
  expect(length(forces.vectors.friction)).toBeCloseTo(9.81 * Math.sin(Math.PI / 12), 12)
  const { force } = largestOf(trajectory)
  expect(frictionText(trajectory.experiment, forces, force)).toBe(
    'Static friction holds it: 2.54\u202fN of at most 4.74\u202fN.',
  )
  const sliding = forcesOf({ trajectory, row: 2 })!
  expect(sliding.vectors.frictionKind).toBe('sliding')
  expect(frictionText(trajectory.experiment, sliding, force)).toBe(
    'Kinetic friction: μk N = 0.5 × 9.48\u202fN = 4.74\u202fN.',
  )
})

test('under the naive rule nothing is ever held', () => {
  const state = changed(opening, { kind: 'mode', mode: 'paper' })
  const { trajectory } = new Simulation().run(state).runners[0]!
  for (let row = 0; row <= trajectory.frames; row++)
    expect(forcesOf({ trajectory, row })!.vectors.frictionKind).toBe('sliding')
  const standing = simulate({ scene: 'ramp', parameters: { angle: 5 }, stopping: 'naive' })
  const first = forcesOf({ trajectory: standing, row: 0 })!
  expect(first.vectors.frictionKind).toBe('none')
  expect(first.vectors.friction).toEqual({ x: -0, y: 0 })
  expect(frictionText(standing.experiment, first, 10)).toMatch(/^No friction at v = 0/)
})

test('a block that has left the track, or blown up, has none', () => {
  const left = simulate({
    scene: 'half-pipe',
    parameters: { position: 3.1 },
    integrator: 'explicit-euler',
  })
  expect(left.outcome.kind).toBe('left-the-track')
  expect(forcesOf({ trajectory: left, row: left.frames })).toBeUndefined()
  expect(forcesOf({ trajectory: left, row: left.frames - 1 })).toBeDefined()
  const blown = simulate({
    scene: 'spring',
    parameters: { stiffness: 4000, position: 1 },
    integrator: 'explicit-euler',
    frames: { kind: 'steady', fps: 10 },
  })
  expect(blown.outcome.kind).toBe('diverged')
  expect(forcesOf({ trajectory: blown, row: blown.frames })).toBeUndefined()
  // So large a run would shrink all arrows to nothing.
  expect(largestOf(blown).force).toBeLessThan(3.1 * 4000)
})

test('the picture has the vectors of the legend, and the scale is that of the whole run', () => {
  const scales = [0, 0.2, 0.5, 1].map((time) => {
    const looking = lab(opening, time, 1)
    const picture = pictureForces(looking)!
    const { forces, runner, row } = lookedAt(looking)!
    expect(runner.trajectory.time[row]!).toBeLessThanOrEqual(time + 1e-9)
    expect(picture.vectors.map(({ tag }) => tag)).toEqual(['G', 'N', 'F', 'ΣF', 'v'])
    for (const { id, x, y } of picture.vectors)
      expect({ x, y }).toEqual(id === 'velocity' ? forces!.velocity : forces!.vectors[id])
    return [picture.largest, picture.fastest]
  })
  expect(new Set(scales.map(String)).size).toBe(1)
})

test('each scene has its own forces', () => {
  const tags = (scene: LabState['scene']) =>
    arrowNames(lab(changed(opening, { kind: 'scene', scene }), 0)).map(({ tag }) => tag)
  expect(tags('fall')).toEqual(['G', 'D', 'ΣF', 'v'])
  expect(tags('spring')).toEqual(['G', 'N', 'F', 'S', 'ΣF', 'v'])
  expect(tags('half-pipe')).toEqual(['G', 'N', 'F', 'ΣF', 'v'])
})

test('a hidden runner has nothing to look at', () => {
  const values = { hidden: true }
  const hidden = changed(opening, { kind: 'runner', index: 1, values })
  expect(lookedAt(lab(hidden, 0.5, 1))).toBeUndefined()
  expect(pictureForces(lab(hidden, 0.5, 1))).toBeUndefined()
  expect(pictureForces(lab(hidden, 0.5, 2))).toBeDefined()
})

test.each([
  [9.4757, 9.81, '9.48'],
  [-0.00004, 9.81, '0.00'],
  [-2.539, 9.81, '−2.54'],
  [345.678, 981, '345.7'],
  [3456.78, 9810, '3457'],
  [0.25, 0.5, '0.2500'],
  [1e-15, 1e-3, '0'],
  [0.001, 0.001, '0.001'],
])('%d beside %d is written %s', (value, largest, text) =>
  expect(quantity(value, largest)).toBe(text),
)

const names = ['gravity', 'normal', 'friction', 'other', 'sum'].map((id) => `force-${id}`)

test.each([':root {', "[data-theme='dark'] {"])('colours of %s can be told apart', (selector) => {
  const path = resolve(import.meta.dirname, '../../../src/styles/theme.css')
  const css = readFileSync(path, 'utf8')
  const block = css.slice(css.indexOf(selector)).split('}')[0]!
  const rgb = (name: string) => {
    const digits = new RegExp(`--${name}: #(\\w{6});`).exec(block)![1]!
    return [0, 2, 4].map((i) => parseInt(digits.slice(i, i + 2), 16) / 255)
  }
  const all = [...names, 'velocity'].map(rgb)
  for (const behind of ['sheet', 'ground', 'paper'])
    for (const colour of all) expect(contrast(colour, rgb(behind))).toBeGreaterThan(4.5)
  all.forEach((a, i) => {
    for (const b of all.slice(i + 1))
      expect(Math.hypot(...a.map((value, k) => value - b[k]!))).toBeGreaterThan(0.25)
  })
})

/** As WCAG defines it. */
function contrast(a: number[], b: number[]): number {
  const [low, high] = [a, b].map(luminance).sort((p, q) => p - q) as [number, number]
  return (high + 0.05) / (low + 0.05)
}

function luminance(colour: number[]): number {
  const [r, g, b] = colour.map((part) =>
    part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4,
  ) as [number, number, number]
  return 0.2126 * r + 0.7152 * g + 0.0722 * b
}
