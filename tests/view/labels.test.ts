import { describe, expect, test } from 'vitest'
import { overlap } from '../../src/chart/geometry.ts'
import type { Box } from '../../src/chart/geometry.ts'
import { placeColumn, placeLabels } from '../../src/view/labels.ts'
import type { Pole } from '../../src/view/labels.ts'

const pole = (x: number, y: number, lean = 1, width = 100, sure = false): Pole => ({
  foot: { x, y },
  width,
  height: 18,
  lean,
  sure,
})
const block = ({ foot }: Pole): Box => ({
  left: foot.x - 25,
  right: foot.x + 25,
  top: foot.y - 3,
  bottom: foot.y + 45,
})

/** A small generator: the same cases at every run. */
function numbers(seed: number): () => number {
  return () => (seed = (seed * 16807) % 2147483647) / 2147483647
}

describe('labels on poles', () => {
  test('wherever blocks stand, no label lies over another, over a block, or outside', () => {
    const random = numbers(7)
    for (let n = 0; n < 2000; n++) {
      const width = 310 + 900 * random()
      const poles = Array.from({ length: 1 + Math.floor(8 * random()) }, () =>
        pole(
          20 + (width - 40) * random(),
          150 + 150 * random(),
          Math.round(random()),
          40 + 80 * random(),
        ),
      )
      const blocks = poles.map(block)
      const labels = placeLabels(poles, blocks, 150, width).filter((label) => label !== undefined)
      labels.forEach((label, i) => {
        expect(label.left).toBeGreaterThanOrEqual(0)
        expect(label.right).toBeLessThanOrEqual(width)
        expect(label.top).toBeGreaterThanOrEqual(0)
        expect(
          [...blocks, ...labels.slice(i + 1)].filter((other) => overlap(label, other)),
        ).toEqual([])
      })
    }
  })

  test('blocks in one place have a tidy stack of labels', () => {
    const poles = Array.from({ length: 4 }, () => pole(300, 250))
    const labels = placeLabels(poles, poles.map(block), 150, 600)
    expect(new Set(labels.map((label) => label?.left))).toEqual(new Set([194]))
    const tops = labels.map((label) => label!.top)
    expect(tops.map((top, i) => (i === 0 ? 21 : tops[i - 1]! - top))).toEqual([21, 21, 21, 21])
  })

  test('what a stack has no room for stands in the canvas’s corners, above all ground, and keeps still', () => {
    let before: (Box | undefined)[] = []
    for (let y = 140; y > 40; y--) {
      const poles = Array.from({ length: 8 }, (_, i) => pole(300, y, 1, 50, i === 7))
      const labels = placeLabels(poles, poles.map(block), 60, 600)
      expect(labels.every((label) => label !== undefined)).toBe(true)
      expect(labels[7]!.aside).toBe(false)
      labels.forEach((label, i) => {
        if (!label!.aside) return
        expect(label!.bottom).toBeLessThan(60)
        if (before[i]) expect(label).toEqual(before[i])
      })
      before = labels.map((label) => (label!.aside ? label : undefined))
    }
    expect(before.filter((label) => label)).toHaveLength(7)
  })

  test('there is always a label of what is sure of its place', () => {
    const random = numbers(3)
    for (let n = 0; n < 500; n++) {
      const sure = Math.floor(8 * random())
      const poles = Array.from({ length: 8 }, (_, i) =>
        pole(20 + 260 * random(), 60 + 150 * random(), Math.round(random()), 90, i === sure),
      )
      expect(placeLabels(poles, poles.map(block), 60, 300)[sure]).toBeDefined()
    }
  })

  test('a label glides as blocks pass each other', () => {
    let before: number | undefined
    for (let x = 100; x < 500; x++) {
      const poles = [pole(300, 250), pole(x, 250)]
      const { bottom } = placeLabels(poles, poles.map(block), 150, 600)[1]!
      if (before !== undefined) expect(Math.abs(bottom - before)).toBeLessThan(2)
      before = bottom
    }
  })
})

describe('labels in a column', () => {
  test('stand where they want to if they can', () => {
    expect(placeColumn([50, 100, 150], 18, 0, 300)).toEqual([50, 100, 150])
  })

  test('share the difference if they can’t', () => {
    expect(placeColumn([100, 100, 100], 20, 0, 300)).toEqual([80, 100, 120])
    expect(placeColumn([100, 90], 20, 0, 300)).toEqual([85, 105])
  })

  test('stay on the canvas', () => {
    expect(placeColumn([0, 0, 0], 20, 4, 300)).toEqual([14, 34, 54])
    expect(placeColumn([400, 400], 20, 0, 300)).toEqual([270, 290])
  })
})
