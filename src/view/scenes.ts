import type { Parameters, Scene, SceneId } from '../physics/index.ts'

/** Where a track bends, between its straight pieces or between its ends [m]. */
export interface Bend {
  readonly from: number
  readonly to: number
  readonly radius: number
  /** Straight pieces join it at both ends. Otherwise the track ends there. */
  readonly joined: boolean
}

/** How pictures show a scene: what is drawn, dragged and labelled there, as far as its track does not tell. */
export interface SceneView {
  /** A line drawing of it, 32 by 20, as an SVG's path. */
  readonly icon: string
  /** The direction in which s grows, in words. */
  readonly forwards: string
  /**
   * What moves is a ball, which falls beside a post; labels stand in a column. Otherwise a block slides on the ground.
   */
  readonly falls: boolean
  /** A spring is drawn from the upper end of the slope to the block. */
  readonly spring?: true
  /** The track climbs from its foot at small s: there its handle is, and its angle. */
  readonly climbs?: true
  /** The track is a belt that moves so fast [m/s]. */
  speed?(parameters: Parameters): number
  /** The shortest part of the track that is shown [m]: a block that never moves still stands on something to drag. */
  least(parameters: Parameters): number
  /** Of a track that is not straight. */
  bend?(parameters: Parameters): Bend
}

/** A straight slope: its upper end is dragged to tilt it, and the angle stands at its foot. */
const slope: Omit<SceneView, 'icon'> = {
  forwards: 'down the slope',
  falls: false,
  least: () => 0.5,
}

const views: Readonly<Record<SceneId, SceneView>> = {
  fall: {
    ...slope,
    icon: 'M12 13a4 4 0 0 1 8 0a4 4 0 0 1-8 0M16 6V1M11 5V2M21 5V2M6 19H26',
    forwards: 'down',
    falls: true,
  },
  ramp: { ...slope, icon: 'M2 18H30L2 4ZM11.5 6.6l6 3 2.2-4.4-6-3Z' },
  'run-out': {
    ...slope,
    icon: 'M2 3L11 13Q15 18 21 18H30M8 6.3l3.6 4 3.4-3-3.6-4Z',
    bend: ({ length, bendRadius, angle }) => ({
      from: length!,
      to: length! + (bendRadius! * angle! * Math.PI) / 180,
      radius: bendRadius!,
      joined: true,
    }),
  },
  'half-pipe': {
    ...slope,
    icon: 'M4 3A12.5 12.5 0 0 0 28 3M9.13 4.29l3.08 3.94-3.94 3.08-3.08-3.94Z',
    forwards: 'to the right',
    least: ({ radius }) => 0.2 * radius!,
    bend: ({ radius }) => {
      const lip = (Math.PI / 2) * radius!
      return { from: -lip, to: lip, radius: radius!, joined: false }
    },
  },
  spring: {
    ...slope,
    icon: 'M2 3V17M2 10H5L7 6L10 14L13 6L16 14L18 10H20M20 6h8v8h-8Z',
    spring: true,
    // A stiff spring's whole motion is within millimetres.
    least: () => 0.01,
  },
  crest: {
    ...slope,
    icon: 'M2 18L9 11Q16 4 23 11L30 18M4.6 12l4-4 3 3-4 4Z',
    forwards: 'over the hill',
    climbs: true,
    bend: ({ crestRadius, angle }) => ({
      from: 0,
      to: (2 * crestRadius! * angle! * Math.PI) / 180,
      radius: -crestRadius!,
      joined: true,
    }),
  },
  belt: {
    ...slope,
    icon: 'M2 3V13M2 8H5L7 4L9 12L11 4L13 8H16M16 4h8v8h-8ZM4 14H28A2 2 0 0 1 28 18H4A2 2 0 0 1 4 14',
    forwards: 'along the belt',
    spring: true,
    speed: ({ beltSpeed }) => beltSpeed!,
    least: () => 0.05,
  },
}

/** How pictures show a scene. */
export function viewOf({ id }: Pick<Scene, 'id'>): SceneView {
  return views[id as SceneId]
}
