// What starts 1e9 m away and falls at 1e6 m/s² for 1e6 s does not get near it [m].
export const FAR = 1e24

/** A place on the track and a speed there, and the forces that are felt: what a scene is asked about. */
export class Contact {
  /** Distance along the track [m] and speed [m/s]. */
  s = NaN
  v = NaN
  /** Every force along the track but friction, per mass [m/s²]. */
  drive = NaN
  /** Normal force per mass, ≥ 0 [m/s²]. */
  press = NaN

  constructor() {
    this.drive = 0
    this.press = 0
  }
}

/**
 * Sets `drive` and `press` of a contact from its `s` and `v`. Numbers come and go in fields, since engines box one that
 * is passed to a function, or returned from it, that they do not compile into its caller.
 */
export type Forces = (contact: Contact) => void

/** The forces as numbers, where that is all they are: no step has to call anything for them. */
export interface PlainForces {
  /** The drive at s = 0 [m/s²]. */
  readonly drive: number
  /** What each metre takes away from it [1/s²], and the square of the speed [1/m], against it; 0 where they are left out. */
  readonly perMetre?: number
  readonly perSquare?: number
  /** Normal force per mass [m/s²]. */
  readonly press: number
}

/** What a step integrates on one piece of the track. */
export type PieceForces = PlainForces | Forces

/** What a scene contributes to a step. */
export interface Law {
  /** Of each piece of the track in turn. */
  readonly forces: readonly PieceForces[]
  /** [kg] */
  readonly mass: number
  /** Coefficients of static and kinetic friction; static is never taken below kinetic. */
  readonly muStatic: number
  readonly muKinetic: number
  /** A force changes with the speed, not with its direction alone. */
  readonly dependsOnSpeed: boolean
  /** The instant at which the speed changes sign matters: a force jumps or has a kink there, or the track has joints. */
  readonly turnMatters: boolean
  /** Where one piece of the track joins the next [m], ascending: piece i ends at joints[i]. */
  readonly joints: readonly number[]
  /** Beyond the first and the last joint there is no track: a block that gets there has left. */
  readonly open: boolean
  /** A speed that only a step which has lost its stability reaches [m/s]. */
  readonly speedLimit: number
}

/** The forces of a piece as a function, whatever they are given as. */
export function feltOn(forces: PieceForces): Forces {
  if (typeof forces === 'function') return forces
  const { drive, perMetre = 0, perSquare = 0, press } = forces
  return (contact) => {
    contact.drive = drive - perMetre * contact.s - perSquare * contact.v * Math.abs(contact.v)
    contact.press = press
  }
}
