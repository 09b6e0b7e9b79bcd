import type { Experiment, Trajectory } from '../../physics/index.ts'
import type { Point } from '../../chart/geometry.ts'
import type { Palette } from '../../view/palette.ts'
import type { Control, Controls, ControlValues } from './control.ts'

/** What a picture is drawn on: a canvas in the page, or at build time something that writes an SVG. */
export interface DrawingSurface {
  readonly context: CanvasRenderingContext2D
  /** [CSS px] */
  readonly width: number
  readonly height: number
  readonly palette: Palette
}

/** All that a figure shows. */
export interface View<V = ControlValues> {
  readonly values: V
  /** Of each of the figure's experiments, in their order. */
  readonly runs: readonly Trajectory[]
  /** The instant shown [s]: 0 in a figure that does not play. */
  readonly time: number
  /** The arrow that the reader points at in the text, by what it is: `gravity`, `normal`, `friction`, … */
  readonly lit?: string | undefined
}

/** A place in a picture by which a control can be dragged. */
export interface Grip extends Point {
  /** The name of the control, a number. */
  readonly control: string
  /** The control's value when the grip is dragged to a point. */
  readonly at: (point: Point) => number
}

/** One picture of a figure; several stand one under the other. */
export interface Panel<V = ControlValues> {
  /** Its height as a part of its width, in a wide column and in a narrow one. */
  readonly shape: { readonly wide: number; readonly narrow: number }
  /** Draws all of it, from the surface's own colour up. Equal views on equal surfaces give equal pictures. */
  draw(surface: DrawingSurface, view: View<V>): void
  grips?(size: Pick<DrawingSurface, 'width' | 'height'>, view: View<V>): readonly Grip[]
}

/** A number under the picture. */
export interface FigureReading {
  readonly label: string
  readonly text: string
  /** The same with every digit. */
  readonly raw?: number
  /** The name of a colour of theme.css, such as `--runner-0`: the one that it has in the picture. */
  readonly colour?: string
}

/** A live figure of the tutorial: plain data and pure functions. */
export interface Figure<V = ControlValues> {
  readonly id: string
  readonly title: string
  /** What there is to see, for those who can't. */
  readonly pictured: string
  readonly controls: Controls
  /** What it runs. The values are whole and in range, as `readValues` gives them. */
  experiments(values: V): Experiment[]
  readonly panels: readonly Panel<V>[]
  /** The outcome, in a sentence or two. */
  says(values: V, runs: readonly Trajectory[], time: number): string
  readings?(values: V, runs: readonly Trajectory[], time: number): readonly FigureReading[]
  /** What to do about it, in a paragraph below the outcome, and how many letters the longest such text has. */
  readonly advice?: { text(values: V): string; readonly longest: number }
  /** It can be played, for so long [s]; 0 while there is nothing to play. */
  duration?(values: V): number
  /** It opens at the start of its time, not at the end. */
  readonly opensAtStart?: true
  /** The controls that change nothing at the moment, by name. */
  idle?(values: V): readonly string[]
  /** What follows from a change of the values besides what was changed. */
  follow?(values: V, before: V): V
  /**
   * An element that takes the place of the pictures once the figure is alive: its name, what defines it, its
   * properties.
   */
  readonly hosted?: {
    readonly tag: string
    define(): Promise<unknown>
    readonly properties: Readonly<Record<string, unknown>>
    /** How much more room it takes than the pictures, in a wide column and in a narrow one [rem]. */
    readonly room: { readonly wide: number; readonly narrow: number }
  }
  /**
   * A button of its own: its name, and the values that pressing it leads to, given when that is [s]; then it plays from the
   * start.
   */
  readonly action?: { label(values: V): string; act(values: V, now: number): V }
}

/** What the values of controls are. */
export type ValuesOf<C extends Controls> = { readonly [K in keyof C]: ValueOf<C[K]> }

type ValueOf<C extends Control> = C extends { type: 'number' }
  ? number
  : C extends { type: 'switch' }
    ? boolean
    : C extends { type: 'frames' }
      ? readonly number[]
      : C extends { options: readonly { id: infer Id }[] }
        ? Id
        : never

/** A figure whose functions know the values of its own controls. */
export function figure<const C extends Controls>(
  given: { readonly controls: C } & Figure<ValuesOf<C>>,
): Figure {
  return given as unknown as Figure
}

/** The narrowest that a wide column is [px]. The container queries of figure.css say the same. */
export const WIDE = 480
