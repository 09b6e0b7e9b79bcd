/** Why a text is no log of frame times, for people. */
export class LogError extends Error {}
