/** The slope that a block lies on, in SI units; the angle in degrees below the horizontal. */
export interface EngineSlope {
  readonly angle: number
  /** The coefficient that the two bodies' friction must combine to, exactly. */
  readonly friction: number
  readonly gravity: number
}

/** A block of an engine on a slope of that engine. Distances in m along the slope, downhill positive. */
export interface EngineBlock {
  /** Sets gravity: `along` the slope and `into` it [m/s²]. */
  pull(along: number, into: number): void
  /** Gives the block a velocity along the slope and none across it [m/s]. */
  push(speed: number): void
  /** Takes one time step of that many seconds. */
  step(dt: number): void
  /** Where the block's centre is, along the slope and above it [m]. */
  along(): number
  above(): number
  /** Velocity along the slope [m/s]. */
  speed(): number
  /** The coefficient of friction that the engine made of the two bodies' own; NaN where it does not say. */
  friction(): number
  /** Gives back what the engine does not collect on its own. */
  free(): void
}

/** A rigid-body engine, and how it is asked for one block on one slope. */
export interface Engine {
  readonly id: string
  /** Its npm package. */
  readonly package: string
  /** Units, friction, sleeping: what a reader must know to judge the figures. */
  readonly setup: string
  /** Loads the engine and returns what makes blocks. */
  load(): Promise<(slope: EngineSlope) => EngineBlock>
}

/** Half the edge of the block, of 1 kg [m]. */
export const halfBlock = 0.5

/** Half the slope's length and thickness [m]; long enough for every scene. */
export const slopeSize = { halfLength: 120, halfThickness: 1 } as const

/** Directions of a slope in a frame with x to the right and y upwards: downhill, and out of it. */
export function directions(angle: number): { sin: number; cos: number } {
  const radians = (angle * Math.PI) / 180
  return { sin: Math.sin(radians), cos: Math.cos(radians) }
}

/** Steps in which a block comes to lie at its engine's own resting gap; twice as many change nothing. */
const SETTLING = 120

/** A block that lies on its slope at rest, under gravity from now on. */
export function settled(
  make: (slope: EngineSlope) => EngineBlock,
  slope: EngineSlope,
): EngineBlock {
  const block = make(slope)
  const { sin, cos } = directions(slope.angle)
  // Pressed only, so that it finds its gap without setting off.
  block.pull(0, slope.gravity * cos)
  for (let i = 0; i < SETTLING; i++) block.step(1 / 60)
  block.push(0)
  block.pull(slope.gravity * sin, slope.gravity * cos)
  return block
}
