import type { Figure } from './figure.ts'

/** A figure of the tutorial, and where to get it when it is needed. */
export interface FigureEntry {
  readonly id: string
  readonly title: string
  readonly load: () => Promise<Figure>
}

/** Every figure, in the order of the tutorial. */
export const figures: readonly FigureEntry[] = [
  {
    id: 'falling-ball',
    title: 'A ball that falls by frames',
    load: () => import('./fallingBall.ts').then((module) => module.fallingBall),
  },
  {
    id: 'forces-on-slope',
    title: 'Three forces and their sum',
    load: () => import('./forcesOnSlope.ts').then((module) => module.forcesOnSlope),
  },
  {
    id: 'mass-cancels',
    title: 'A light block and a heavy one',
    load: () => import('./massCancels.ts').then((module) => module.massCancels),
  },
  {
    id: 'critical-angle',
    title: 'How steep until it slides?',
    load: () => import('./criticalAngle.ts').then((module) => module.criticalAngle),
  },
  {
    id: 'two-become-one',
    title: 'Two dimensions become one',
    load: () => import('./twoBecomeOne.ts').then((module) => module.twoBecomeOne),
  },
  {
    id: 'area-under-v',
    title: 'The area under the speed',
    load: () => import('./areaUnderV.ts').then((module) => module.areaUnderV),
  },
  {
    id: 'where-does-it-stop',
    title: 'Where will it stop?',
    load: () => import('./whereDoesItStop.ts').then((module) => module.whereDoesItStop),
  },
  {
    id: 'chatter',
    title: 'The velocity near its stop',
    load: () => import('./chatter.ts').then((module) => module.chatter),
  },
  {
    id: 'three-stops',
    title: 'One kick, three frame rates',
    load: () => import('./threeStops.ts').then((module) => module.threeStops),
  },
  {
    id: 'frames-and-ticks',
    title: 'Frames and physics steps',
    load: () => import('./framesAndTicks.ts').then((module) => module.framesAndTicks),
  },
  {
    id: 'hitch',
    title: 'One long frame',
    load: () => import('./hitch.ts').then((module) => module.hitch),
  },
  {
    id: 'your-frames',
    title: 'Your own frames',
    load: () => import('./yourFrames.ts').then((module) => module.yourFrames),
  },
  {
    id: 'half-pipe-energy',
    title: 'Who gains energy, who keeps it?',
    load: () => import('./halfPipeEnergy.ts').then((module) => module.halfPipeEnergy),
  },
  {
    id: 'spring-limit',
    title: 'How stiff is too stiff?',
    load: () => import('./springLimit.ts').then((module) => module.springLimit),
  },
  {
    id: 'flung-out',
    title: 'Thrown out by its own method',
    load: () => import('./flungOut.ts').then((module) => module.flungOut),
  },
  {
    id: 'speed-against-error',
    title: 'Speed against error',
    load: () => import('./speedAgainstError.ts').then((module) => module.speedAgainstError),
  },
  {
    id: 'paper-step',
    title: 'The step as printed, corrected line by line',
    load: () => import('./paperStep.ts').then((module) => module.paperStep),
  },
  {
    id: 'break-it',
    title: 'Try to break it',
    load: () => import('./breakIt.ts').then((module) => module.breakIt),
  },
]
