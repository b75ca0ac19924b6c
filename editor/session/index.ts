export {
  createSession,
  LAYERS,
  type Layer,
  RATES,
  type Session,
  type SessionStore,
  TOOLS,
  type Tool,
} from './session.ts';
