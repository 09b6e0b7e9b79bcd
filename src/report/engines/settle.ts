import { directions } from './engine.ts'
import type { Block, Slope } from './engine.ts'

/** Steps in which a block comes to lie at its engine's own resting gap; twice as many change nothing. */
const SETTLING = 120

/** A block that lies on its slope at rest, under gravity from now on. */
export function settled(make: (slope: Slope) => Block, slope: Slope): Block {
  const block = make(slope)
  const { sin, cos } = directions(slope.angle)
  // Pressed only, so that it finds its gap without setting off.
  block.pull(0, slope.gravity * cos)
  for (let i = 0; i < SETTLING; i++) block.step(1 / 60)
  block.push(0)
  block.pull(slope.gravity * sin, slope.gravity * cos)
  return block
}
