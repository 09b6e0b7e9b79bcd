import { FrameStrip } from './frameStrip.ts'

customElements.define('frame-strip', FrameStrip)
