export { TEMPLATES, type Template } from './templates.ts';
