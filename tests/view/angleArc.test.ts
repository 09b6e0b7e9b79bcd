import { expect, test } from 'vitest'
import { drawAngle } from '../../src/view/angleArc.ts'
import { layOut } from '../../src/view/layout.ts'
import { Projection } from '../../src/view/projection.ts'
import { drawSlopeAngle, slopeThrough } from '../../src/figures/shared/slope.ts'
import { slackBox } from '../../src/view/spring.ts'
import { paper, plainPalette as palette } from './paper.ts'
import { pictureOf } from './pictures.ts'

test.each([0, 2, 10, 20, 30, 40])(
  'on a slope of %d° the angle is not written over the spring’s mark',
  (angle) => {
    for (const [width, height] of [
      [1180, 460],
      [720, 420],
      [350, 300],
      [294, 304],
    ] as const) {
      const picture = pictureOf({ scene: 'spring', parameters: { angle } })
      const layout = layOut(picture, width, height)
      const projection = new Projection(picture.scene, picture.parameters, layout.camera)
      const { words, context } = paper()
      drawAngle(context, picture, layout, projection, palette)
      const [label] = words
      expect(words.map(({ text }) => text)).toEqual([`${angle}°`])
      const mark = slackBox(context, layout, projection, palette)
      const apart =
        label!.left > mark.right ||
        label!.right < mark.left ||
        label!.top > mark.bottom ||
        label!.bottom < mark.top
      expect(apart, `${width} px`).toBe(true)
    }
  },
)

test('the angle of a run-out is written on the canvas', () => {
  for (const angle of [2, 30, 51.5, 60]) {
    const picture = pictureOf({ scene: 'run-out', parameters: { angle, speed: 2 } })
    const layout = layOut(picture, 294, 304)
    const { words, context } = paper()
    drawAngle(
      context,
      picture,
      layout,
      new Projection(picture.scene, picture.parameters, layout.camera),
      palette,
    )
    expect(words[0]!.left, `${angle}°`).toBeGreaterThanOrEqual(0)
  }
})

test.each([1, 10, 20, 35, 60])('at %d° no slope goes through its angle', (degrees) => {
  const slope = slopeThrough({ x: 180, y: 160 }, degrees)
  const vertex = { x: 30, y: 250 }
  for (const radius of [60, 120]) {
    const { words, context } = paper()
    drawSlopeAngle(context, slope, vertex, radius, palette)
    const { left, top, bottom } = words[0]!
    const surface = vertex.y - (left - vertex.x) * Math.tan((degrees * Math.PI) / 180)
    expect(top > surface + 1 || bottom < surface - 1, `${radius} px`).toBe(true)
  }
})
