/** The reference does not know how to go on: the caller leaves the scene out, and counts it. */
export class NotCovered extends Error {}
