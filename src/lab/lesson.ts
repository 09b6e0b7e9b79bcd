import { scenes } from '../physics/index.ts'
import type { Problem, Scene } from '../physics/index.ts'
import { parameterOf } from '../view/handles.ts'
import type { HandleId } from '../view/picture.ts'
import type { Change } from './state/change.ts'

/** What a lab is set up with for a lesson: as attributes or an address say it. */
export interface LessonAsked {
  /** Nothing can be used but playing and the time. */
  readonly locked?: boolean
  /** What can be used besides, as “angle fps”: what is not named can’t be. */
  readonly controls?: string | null
  /** What readers are to find out: `exact`, `spread`. */
  readonly hide?: string | null
}

/** What readers may use of a lab, and what is kept from them. */
export interface Lesson {
  readonly locked: boolean
  may(control: string): boolean
  /** Why readers may not make a change; empty where they may. */
  refusal(change: Change): string
  hides(answer: Answer): boolean
  /** The handles that the picture has. */
  readonly handles: readonly HandleId[]
}

export const answers = ['exact', 'spread'] as const
type Answer = (typeof answers)[number]

/** The controls of every scene, in the order of the page; the parameters come before them. */
const common: Readonly<Record<string, string>> = {
  duration: 'Duration',
  timeScale: 'Time scale',
  fps: 'Frame rate',
  frames: 'Frames',
  integrator: 'Integrator',
  stopping: 'Stopping',
  timestep: 'Time step',
  runners: 'Add, hide and remove runners',
  modes: 'The buttons for all runners',
  scene: 'Scene',
  presets: 'Presets and engines',
  forces: 'Forces',
  measures: 'Measures',
  step: 'Step by step',
  share: 'Share',
}

/** What an engine's name sets. */
export const ofEngine = ['integrator', 'stopping', 'timestep']

/** These would tell what is hidden. */
const telling = ['measures', 'step', 'share']

/** The controls of a scene by their names, and what people call them. */
export function controlsOf({ parameters }: Pick<Scene, 'parameters'>): Record<string, string> {
  const own = Object.entries(parameters).map(([name, { label }]) => [name, label] as const)
  return { ...Object.fromEntries(own), ...common }
}

/** The lesson that was asked for, undefined where none was; what is wrong with it is told and left out. */
export function lessonOf({ locked = false, controls, hide }: LessonAsked): {
  readonly lesson: Lesson | undefined
  readonly problems: readonly Problem[]
} {
  const known = Object.assign({}, ...scenes.map(controlsOf)) as Record<string, string>
  const used = namesIn('controls', controls, Object.keys(known))
  const hidden = namesIn('hide', hide, answers)
  const problems = [...used.problems, ...hidden.problems]
  const isLimited = locked || isGiven(controls)
  if (!isLimited && !isGiven(hide)) return { lesson: undefined, problems }
  const may = (control: string) =>
    isLimited
      ? !locked && used.names.includes(control)
      : !(hidden.names.length > 0 && telling.includes(control))
  const handles = (Object.keys(parameterOf) as HandleId[]).filter((id) => may(parameterOf[id]))
  const lesson: Lesson = {
    locked: locked || (isLimited && used.names.length === 0),
    may,
    refusal: (change) => (usedBy(change).every(may) ? '' : 'This lesson leaves it as it is.'),
    hides: (answer) => hidden.names.includes(answer),
    handles,
  }
  return { lesson, problems }
}

/** The controls that make a change. */
function usedBy(change: Change): readonly string[] {
  switch (change.kind) {
    case 'parameters':
      return Object.keys(change.values)
    case 'runner':
      return Object.keys(change.values).flatMap((key) =>
        key === 'engine' ? ofEngine : key in common ? key : 'runners',
      )
    case 'option':
      return [change.key === 'fps' ? 'fps' : change.of]
    case 'mode':
      return ['modes']
    case 'state':
      return ['presets']
    case 'scene':
    case 'duration':
    case 'timeScale':
      return [change.kind]
    default:
      return ['runners']
  }
}

/** The names in a list with blanks or commas between, and a problem for each that there is not. */
export function namesIn(
  path: string,
  text: string | null | undefined,
  known: readonly string[],
): { readonly names: readonly string[]; readonly problems: readonly Problem[] } {
  const all = (text ?? '').split(/[\s,]+/).filter(Boolean)
  const isKnown = (name: string) => known.includes(name)
  const problems = all
    .filter((name) => !isKnown(name))
    .map((name) => ({ path, message: `there is no “${name}”; there are: ${known.join(', ')}` }))
  return { names: all.filter(isKnown), problems }
}

function isGiven(text: string | null | undefined): boolean {
  return text !== undefined && text !== null
}

const keys = ['locked', 'controls', 'hide'] as const

/** A lesson as part of an address: “controls=angle,fps&hide=exact”. */
export function writeLesson({ locked, controls, hide }: LessonAsked): string {
  const list = (name: string, text: string | null | undefined) =>
    text
      ? [
          `${name}=${text
            .trim()
            .split(/[\s,]+/)
            .join(',')}`,
        ]
      : []
  return [...(locked ? ['locked=1'] : list('controls', controls)), ...list('hide', hide)].join('&')
}

/** An address in two: what it says about a lesson, and what about a state. */
export function splitAddress(address: string): {
  readonly said: string
  readonly rest: string
  readonly asked: LessonAsked
} {
  const isLesson = (field: string) =>
    keys.some((key) => field === key || field.startsWith(`${key}=`))
  const fields = address.split('&')
  const said = fields.filter(isLesson).join('&')
  const values = new URLSearchParams(said)
  return {
    said,
    rest: fields.filter((field) => !isLesson(field)).join('&'),
    asked: {
      locked: values.has('locked') && values.get('locked') !== '0',
      controls: values.get('controls'),
      hide: values.get('hide'),
    },
  }
}
