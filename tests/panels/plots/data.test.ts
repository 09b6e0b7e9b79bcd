import { describe, expect, test } from 'vitest'
import { energyResidual, presentationErrors } from '../../../src/measure/index.ts'
import { opening } from '../../../src/lab/state/opening.ts'
import { drawingOf, EXACT } from '../../../src/panels/plots/curves.ts'
import type { PlotDrawing } from '../../../src/panels/plots/curves.ts'
import { plotKinds } from '../../../src/panels/plots/kinds.ts'
import { inFull, readingsAt, spoken } from '../../../src/panels/plots/readings.ts'
import { nearestRow, tableOf } from '../../../src/panels/plots/table.ts'
import { Simulation } from '../../../src/lab/state/simulation.ts'
import type { Simulated } from '../../../src/lab/state/simulation.ts'
import { changed } from '../../../src/lab/state/change.ts'
import type { Change } from '../../../src/lab/state/change.ts'
import { rowAt } from '../../../src/view/timeline.ts'

const kind = (id: string) => plotKinds.find((each) => each.id === id)!

function simulated(...changes: Change[]): Simulated {
  return new Simulation().run(changes.reduce(changed, opening))
}

const curve = (drawing: PlotDrawing, paletteIndex: number) =>
  drawing.curves.find((each) => each.paletteIndex === paletteIndex)!

/** So wide that every frame has its column. */
const WIDE = 5000

describe('what is plotted is what was simulated, number for number', () => {
  const lab = simulated()

  test.each([
    ['position', (i: number) => lab.visible[i]!.trajectory.drawnS],
    ['speed', (i: number) => lab.visible[i]!.trajectory.v],
    ['energy', (i: number) => energyResidual(lab.visible[i]!.trajectory)],
  ] as const)('%s', (id, values) => {
    const drawing = drawingOf(kind(id), lab, WIDE, 200)
    for (let i = 0; i < 3; i++) {
      const { x, y } = curve(drawing, i)
      expect(x).toEqual([...lab.visible[i]!.trajectory.time])
      expect(y).toEqual([...values(i)])
    }
  })

  test('error, but for rounding', () => {
    for (const { trajectory } of lab.visible) {
      const values = kind('error').of.values(trajectory)
      const errors = presentationErrors(trajectory).each.map(Math.abs)
      // The path is below two metres.
      expect(values[0]).toBe(0)
      expect([...values]).toEqual([...errors.map((error) => (error < 2e-11 ? 0 : error))])
    }
  })

  test('speed over position', () => {
    const drawing = drawingOf(kind('phase'), lab, WIDE, WIDE)
    const { s, v } = lab.visible[0]!.trajectory
    const { x, y } = curve(drawing, 0)
    // At rest all frames are one point, and the last.
    const moving = v.findIndex((speed, row) => row > 0 && speed === 0) + 1
    expect(x).toEqual([...s.subarray(0, moving), s.at(-1)!])
    expect(y).toEqual([...v.subarray(0, moving), v.at(-1)!])
  })

  test('the exact motion', () => {
    const { x, y } = curve(drawingOf(kind('speed'), lab, WIDE, 200), EXACT)
    expect(x[0]).toBe(0)
    expect(x.at(-1)).toBe(1)
    expect(y).toEqual(x.map((time) => lab.exact(time, { s: 0, v: 0 }).v))
    expect(
      curve(drawingOf(kind('energy'), lab, WIDE, 200), EXACT).y.every((each) => each === 0),
    ).toBe(true)
    expect(curve(drawingOf(kind('error'), lab, WIDE, 200), EXACT)).toBeUndefined()
  })
})

test('a stop in the first thousandth of a long run is drawn as the parabola that it is', () => {
  const lab = simulated({ kind: 'duration', duration: 600 })
  const { x, y, time } = curve(drawingOf(kind('phase'), lab, 700, 200), EXACT)
  expect(y.filter((speed) => speed < -1 && speed > -4).length).toBeGreaterThan(3)
  for (let i = 0; i < x.length; i++) {
    const { s, v } = lab.exact(time[i]!, { s: 0, v: 0 })
    expect([x[i], y[i]]).toEqual([s, v])
  }
})

test('swings that cannot be followed are a band over time, and no tangle over position', () => {
  const lab = simulated(
    { kind: 'scene', scene: 'spring' },
    { kind: 'parameters', values: { muKinetic: 0, muStatic: 0, stiffness: 14_400 } },
    { kind: 'duration', duration: 590 },
  )
  const overTime = curve(drawingOf(kind('position'), lab, 700, 200), EXACT)
  const [low, high] = [Math.min(...overTime.y), Math.max(...overTime.y)]
  // In every tenth of it both ends of the swing come within a hundredth.
  for (let tenth = 0; tenth < 10; tenth++) {
    const part = overTime.y.filter((_, i) => Math.floor(overTime.time[i]! / 59) === tenth)
    expect(Math.max(...part)).toBeGreaterThan(high - (high - low) / 100)
    expect(Math.min(...part)).toBeLessThan(low + (high - low) / 100)
  }
  const overPosition = curve(drawingOf(kind('phase'), lab, 700, 200), EXACT)
  expect(overPosition.time.at(-1)).toBeLessThan(590)
  // From point to point it goes along its oval, which is as long as some three times its width.
  const { x } = overPosition
  for (let i = 1; i < x.length; i++)
    expect(Math.abs(x[i]! - x[i - 1]!)).toBeLessThan((high - low) / 8)
})

test('hidden runners are not plotted', () => {
  const lab = simulated({ kind: 'runner', index: 1, values: { hidden: true } })
  const paletteIndices = drawingOf(kind('position'), lab, WIDE, 200).curves.map(
    ({ paletteIndex }) => paletteIndex,
  )
  expect(paletteIndices).toEqual([0, 2, EXACT])
  expect(readingsAt(kind('position'), lab, 0.5)).toHaveLength(3)
})

test('a runner that blows up does not press the others flat, and its curve has only numbers', () => {
  const lab = simulated(
    { kind: 'scene', scene: 'spring' },
    { kind: 'parameters', values: { stiffness: 4000 } },
  )
  expect(lab.visible[0]!.trajectory.outcome.kind).toBe('diverged')
  const positions = Array.from({ length: 500 }, (_, i) => lab.exact(i / 125, { s: 0, v: 0 }).s)
  const span = Math.max(...positions) - Math.min(...positions)
  for (const each of plotKinds) {
    const drawing = drawingOf(each, lab, 400, 200)
    for (const axis of [drawing.across, drawing.up]) {
      expect(axis.to).toBeGreaterThan(axis.from)
      expect(axis.to - axis.from).toBeLessThan(1e7)
      expect(axis.ticks(6).length).toBeGreaterThan(1)
    }
    for (const { x, y } of drawing.curves) expect([...x, ...y].every(Number.isFinite)).toBe(true)
  }
  const { up } = drawingOf(kind('position'), lab, 400, 200)
  expect(up.to - up.from).toBeLessThan(3.5 * span)
})

test('readings are those of the last frame shown by then, and exact ones of that very time', () => {
  const lab = simulated()
  const readings = readingsAt(kind('position'), lab, 0.55)
  expect(readings.map(({ name }) => name)).toEqual(['10 fps', '30 fps', '120 fps', 'exact'])
  expect(readings.map(({ y }) => y)).toEqual([
    ...lab.visible.map(({ trajectory }) => trajectory.drawnS[rowAt(trajectory, 0.55)]!),
    lab.exact(0.55, { s: 0, v: 0 }).s,
  ])
  expect(readings[0]!.x).toBe(lab.visible[0]!.trajectory.time[5])
  expect(readings[0]!.text).toBe('−1.41\u202fm')
  expect(inFull(kind('position'), readings[0]!)).toBe(`10 fps: ${readings[0]!.y} m, at t = 0.5 s`)
  expect(spoken(kind('position'), readings, 0.55)).toContain(
    'Position at 0.55\u202fs: 10 fps −1.41\u202fm',
  )
})

test('errors that are rounding are called so', () => {
  const lab = simulated({ kind: 'mode', mode: 'located' })
  const texts = readingsAt(kind('error'), lab, 1).map(({ text }) => text)
  expect(texts).toEqual(['rounding', 'rounding', 'rounding'])
  const { up } = drawingOf(kind('error'), lab, 400, 200)
  expect(up.ticks(6)[0]!.label).toBe('rounding')
  expect(up.at(0)).toBe(up.ticks(6)[0]!.at)
  expect(up.at(0.001)).toBe(-3)
})

test.each([
  [0.1464, '0.146\u202fm'],
  [0.00554, '5.54\u202fmm'],
  [3.14e-6, '3.14\u202fµm'],
  [6.8e-11, '68\u202fpm'],
  [0, 'rounding'],
  [12345, '12345\u202fm'],
])('an error of %d m', (value, text) => expect(kind('error').of.text(value)).toBe(text))

test('the energy residual counts the heat of drag', () => {
  const lab = simulated({ kind: 'scene', scene: 'fall' }, { kind: 'mode', mode: 'located' })
  const { values } = kind('energy').of
  for (const { trajectory } of lab.visible) {
    const { heat, frames } = trajectory
    expect(heat[frames]!).toBeGreaterThan(1)
    expect(Math.abs(values(trajectory)[frames]!)).toBeLessThan(0.05 * heat[frames]!)
  }
})

test('a table has a row for each of at most 25 even times, with the nearest frames', () => {
  const lab = simulated()
  const { head, rows } = tableOf(kind('position'), lab)
  expect(head).toEqual([
    'time (s)',
    '10 fps, position (m)',
    '30 fps, position (m)',
    '120 fps, position (m)',
    'exact, position (m)',
  ])
  expect(rows).toHaveLength(25)
  expect(rows[0]!.time).toBe('0.00')
  expect(rows[24]!.time).toBe('1.00')
  rows.forEach(({ cells }, i) => {
    const time = i / 24
    lab.visible.forEach(({ trajectory }, n) => {
      const row = nearestRow(trajectory, time)
      const distances = trajectory.time.map((each) => Math.abs(each - time))
      expect(distances[row]).toBe(Math.min(...distances))
      expect(cells[n]!.title).toBe(`${trajectory.drawnS[row]} m at t = ${trajectory.time[row]} s`)
    })
  })
  expect(rows[24]!.cells.map(({ text }) => text)).toEqual(['−1.472', '−1.635', '−1.697', '−1.718'])
  expect(tableOf(kind('phase'), lab).head).toHaveLength(1 + 2 * 4)
  const slow = simulated(...([1, 1] as const).map((index) => ({ kind: 'remove', index }) as const))
  expect(tableOf(kind('error'), slow).rows).toHaveLength(11)
})
