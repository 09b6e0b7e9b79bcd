import type { Experiment, IntegratorId, SceneId, StoppingId, TimestepId } from '../physics/index.ts'

/* What markup may set on the elements, for the types of frameworks: attributes as text, properties as values. */

/** Of `<slide-lab>`. */
export interface SlideLabProperties {
  experiment?: Experiment | readonly Experiment[] | string | null
  scene?: SceneId | null
  /** A frame rate for each block, as `10 30 120`. */
  fps?: string | number | readonly number[] | null
  integrator?: IntegratorId | null
  stopping?: StoppingId | null
  /** A policy with its options, as a value or as JSON, or the id of one. */
  timestep?: NonNullable<Experiment['timestep']> | TimestepId | `{${string}` | null
  /** [s] */
  duration?: number | `${number}`
  compact?: boolean
  locked?: boolean
  controls?: string | null
  hide?: string | null
  theme?: 'light' | 'dark' | null
}

/** Of `<slide-figure>`. */
export interface SlideFigureProperties {
  name?: string | null
  /** Of its controls, by name; as a value or as JSON. */
  values?: Readonly<Record<string, unknown>> | string | null
  locked?: boolean
  controls?: string | null
  hide?: string | null
  theme?: 'light' | 'dark' | null
}

/** The events of `<slide-lab>` by their names. */
export interface SlideLabEvents {
  change: CustomEvent<{ experiments: readonly Experiment[] }>
  timeupdate: CustomEvent<{ time: number }>
  error: CustomEvent<{ message: string; problems: readonly { path: string; message: string }[] }>
}

/** The events of `<slide-figure>` by their names. */
export interface SlideFigureEvents {
  change: CustomEvent<Readonly<Record<string, unknown>>>
  timeupdate: CustomEvent<{ time: number }>
  error: CustomEvent<{ message: string }>
}
