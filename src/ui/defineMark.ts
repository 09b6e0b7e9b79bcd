import { RunnerMark } from './runnerMark.ts'

/* To be imported for the element alone, by everything that shows marks outside of pictures. */
customElements.define('runner-mark', RunnerMark)
