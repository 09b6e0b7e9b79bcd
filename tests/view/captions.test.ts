import { afterAll, beforeAll, describe, expect, test, vi } from 'vitest'
import { forcesAt } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import { drawAngle } from '../../src/view/angleArc.ts'
import { overlap } from '../../src/chart/geometry.ts'
import { forceDrawing } from '../../src/view/forces.ts'
import { layOut } from '../../src/view/layout.ts'
import { degrees } from '../../src/chart/numbers.ts'
import { paint } from '../../src/view/paint.ts'
import type { Picture } from '../../src/view/picture.ts'
import { settingOf } from '../../src/view/setting.ts'
import { rowAt } from '../../src/view/timeline.ts'
import { paper, plainPalette, stubPaths } from './paper.ts'
import type { Line, Word } from './paper.ts'
import { pictureOf } from './pictures.ts'

beforeAll(stubPaths)
afterAll(() => void vi.unstubAllGlobals())

/** The stage on pages of 1440, 768, 390 and 320 px. */
const sizes = [
  [1180, 448],
  [706, 305],
  [350, 304],
  [294, 304],
] as const
const rates = [10, 20, 30, 60, 90, 120, 144, 240]

/** The paper's stops, gentle and steep; eight runners of them come to rest within a few pixels. */
const methods = { integrator: 'semi-implicit-euler', stopping: 'clamped' } as const
const experiments: Experiment[] = [
  ...[3, 15, 35, 50].map((angle) => ({
    ...{ ...methods, scene: 'ramp' as const, duration: 1.5 },
    parameters: { angle, muStatic: 0.5, muKinetic: 0.5, speed: angle === 35 ? 2 : -5 },
  })),
  ...[8, 30, 60].map((angle) => ({
    ...{ ...methods, scene: 'run-out' as const, duration: 5, parameters: { angle } },
  })),
  ...[0.6, 2.8].map((position) => ({
    ...{ ...methods, scene: 'half-pipe' as const, duration: 4 },
    parameters: { position, muStatic: 0.4, muKinetic: 0.3 },
  })),
  ...[5, 30, 60].map((angle) => ({
    ...{ ...methods, scene: 'spring' as const, duration: 3, parameters: { angle, position: 1.5 } },
  })),
  ...[-6, 0].map((speed) => ({
    ...{ ...methods, scene: 'fall' as const, duration: 2, parameters: { speed, drag: 0.2 } },
  })),
]

/** A small generator: the same cases at every run. */
function numbers(seed: number): () => number {
  return () => (seed = (seed * 16807) % 2147483647) / 2147483647
}

function withForces(picture: Picture, experiment: Experiment): Picture {
  const { trajectory } = picture.runners[picture.selected!]!
  const row = rowAt(trajectory, picture.time)
  const v = trajectory.v[row]!
  const { along, across, ...forces } = forcesAt(experiment, { s: trajectory.s[row]!, v })
  const tags = { gravity: 'G', normal: 'N', friction: 'F', other: 'S', sum: 'ΣF' } as const
  const vectors = (Object.keys(tags) as (keyof typeof tags)[]).map((id) => ({
    ...{ id, tag: tags[id], ...forces[id] },
  }))
  const velocity = { id: 'velocity' as const, tag: 'v', x: v * along.x, y: v * along.y }
  const all = [...vectors, velocity]
  const fastest = Math.max(...trajectory.v.map(Math.abs))
  return { ...picture, forces: { vectors: all, along, across, largest: 40, fastest } }
}

/** What is written in a picture, and the lines from blocks to their labels. */
function drawn(picture: Picture, width: number, height: number) {
  const { words, lines, context } = paper()
  const setting = settingOf(picture, layOut(picture, width, height))
  const { layout, projection } = setting
  const draw = () =>
    'angle' in picture.parameters
      ? drawAngle(context, picture, layout, projection, plainPalette)
      : []
  paint(context, picture, setting, plainPalette, { draw }, forceDrawing)
  const leaders = lines.filter(
    ({ from, to, width, colour, isDashed }) =>
      width === 1 &&
      !isDashed &&
      /^text|^ink/.test(colour) &&
      Math.hypot(to.x - from.x, to.y - from.y) > 0.1,
  )
  // What is written once more at its place is seen once.
  const isLast = (word: Word, i: number) =>
    !words.slice(i + 1).some((later) => later.text === word.text && later.left === word.left)
  return { words: words.filter(isLast), leaders }
}

/** Whether a line goes through a word. */
function crosses({ from, to }: Line, { left, right, top, bottom }: Word): boolean {
  return Array.from({ length: 201 }, (_, i) => i / 200).some((part) => {
    const x = from.x + (to.x - from.x) * part
    const y = from.y + (to.y - from.y) * part
    return x > left && x < right && y > top && y < bottom
  })
}

describe.each(experiments)('$scene $parameters', (experiment) => {
  test.each(sizes)('on %d × %d no words lie on each other', (width, height) => {
    const random = numbers(width)
    for (const count of [1, 3, 8]) {
      const still = pictureOf(
        experiment,
        rates.slice(-count).sort((a, b) => a - b),
      )
      for (const part of [0, random(), random(), random(), random(), 1]) {
        const selected = Math.floor(count * random())
        const calm = { ...still, time: part * still.duration, selected }
        for (const picture of [calm, withForces(calm, experiment)]) {
          const { words, leaders } = drawn(picture, width, height)
          const where = `${count} at ${picture.time} s, forces ${picture.forces !== undefined}`
          const texts = words.map(({ text }) => text)
          for (const name of [picture.runners[selected]!.name, 'exact'])
            expect(
              texts.some((text) => text.startsWith(name)),
              `${name}, ${where}`,
            ).toBe(true)
          // An arrow would hide the number of the angle that was written before it.
          if (picture.forces && 'angle' in picture.parameters)
            expect(texts.indexOf(degrees(picture.parameters.angle!))).toBeGreaterThan(
              texts.indexOf('G'),
            )
          words.forEach((word, i) => {
            const others = words.slice(i + 1).filter((other) => overlap(word, other))
            expect(others, `${word.text}, ${where}`).toEqual([])
            // Beside a fall they fan out, and an arrow's letters may stand on them.
            if (experiment.scene !== 'fall' || /\d|exact/.test(word.text)) {
              const lines = leaders.filter((line) => crosses(line, word))
              expect(lines, `${word.text}, ${where}`).toEqual([])
            }
            expect(word.left, `${word.text}, ${where}`).toBeGreaterThan(-1)
            expect(word.right, `${word.text}, ${where}`).toBeLessThan(width + 1)
            expect(word.top, `${word.text}, ${where}`).toBeGreaterThan(-1)
            expect(word.bottom, `${word.text}, ${where}`).toBeLessThan(height + 1)
          })
        }
      }
    }
  })
})
