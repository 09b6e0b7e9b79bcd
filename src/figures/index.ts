import type { Figure } from './shared/figure.ts'

/** A figure of the tutorial, and where to get it when it is needed. */
export interface FigureEntry {
  readonly id: string
  readonly title: string
  readonly load: () => Promise<Figure>
}

/** Together, since they are much alike: loaded one by one they would be half as large again. */
const all = () => import('./all.ts')

/** Every figure, in the order of the tutorial. */
export const figures: readonly FigureEntry[] = [
  {
    id: 'falling-ball',
    title: 'A ball that falls by frames',
    load: () => all().then(({ fallingBall }) => fallingBall),
  },
  {
    id: 'forces-on-slope',
    title: 'Three forces and their sum',
    load: () => all().then(({ forcesOnSlope }) => forcesOnSlope),
  },
  {
    id: 'mass-cancels',
    title: 'A light block and a heavy one',
    load: () => all().then(({ massCancels }) => massCancels),
  },
  {
    id: 'critical-angle',
    title: 'How steep until it slides?',
    load: () => all().then(({ criticalAngle }) => criticalAngle),
  },
  {
    id: 'two-become-one',
    title: 'Two dimensions become one',
    load: () => all().then(({ twoBecomeOne }) => twoBecomeOne),
  },
  {
    id: 'area-under-v',
    title: 'The area under the speed',
    load: () => all().then(({ areaUnderV }) => areaUnderV),
  },
  {
    id: 'where-does-it-stop',
    title: 'Where will it stop?',
    load: () => all().then(({ whereDoesItStop }) => whereDoesItStop),
  },
  {
    id: 'chatter',
    title: 'The velocity near its stop',
    load: () => all().then(({ chatter }) => chatter),
  },
  {
    id: 'three-stops',
    title: 'One kick, three frame rates',
    load: () => all().then(({ threeStops }) => threeStops),
  },
  {
    id: 'frames-and-ticks',
    title: 'Frames and physics steps',
    load: () => all().then(({ framesAndTicks }) => framesAndTicks),
  },
  {
    id: 'hitch',
    title: 'One long frame',
    load: () => all().then(({ hitch }) => hitch),
  },
  {
    id: 'your-frames',
    title: 'Your own frames',
    load: () => all().then(({ yourFrames }) => yourFrames),
  },
  {
    id: 'half-pipe-energy',
    title: 'Who gains energy, who keeps it?',
    load: () => all().then(({ halfPipeEnergy }) => halfPipeEnergy),
  },
  {
    id: 'spring-limit',
    title: 'How stiff is too stiff?',
    load: () => all().then(({ springLimit }) => springLimit),
  },
  {
    id: 'flung-out',
    title: 'Thrown out by its own method',
    load: () => all().then(({ flungOut }) => flungOut),
  },
  {
    id: 'speed-against-error',
    title: 'Speed against error',
    load: () => all().then(({ speedAgainstError }) => speedAgainstError),
  },
  {
    id: 'paper-step',
    title: 'The step as printed, corrected line by line',
    load: () => all().then(({ paperStep }) => paperStep),
  },
  {
    id: 'break-it',
    title: 'Try to break it',
    load: () => all().then(({ breakIt }) => breakIt),
  },
]
