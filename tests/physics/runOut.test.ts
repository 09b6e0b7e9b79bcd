import { expect, it } from 'vitest'
import { scenes } from '../../src/physics/index.ts'
import type { Scene } from '../../src/physics/index.ts'

const runOut: Scene = scenes.find(({ id }) => id === 'run-out')!

it.each([{ angle: 40 }, { length: 3 }, { bendRadius: 2.5 }])(
  'a run-out of another shape is another track: %o',
  (changed) => {
    const usual = { angle: 30, length: 4, bendRadius: 1.5 }
    const other = { ...usual, ...changed }
    // On the flat the height is what slope and bend have left of it.
    const height = ({ angle, length, bendRadius }: typeof usual) => {
      const slope = (angle * Math.PI) / 180
      return -length * Math.sin(slope) - bendRadius * (1 - Math.cos(slope))
    }
    for (const shape of [usual, other, usual])
      expect(runOut.place(shape, 20).y).toBeCloseTo(height(shape), 12)
  },
)
