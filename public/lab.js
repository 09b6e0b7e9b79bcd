/* By this file slide-lab.js knows that the lab is served beside it. */
export default 'any-frame-rate'
