export { TEMPLATES, type Template } from './templates.ts';

/** The shipped levels: loaded when somebody asks for them. */
export const loadSamples = async () => (await import('./samples.ts')).SAMPLES;
