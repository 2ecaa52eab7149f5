#include <scb_record.h>

/* Where SCB_RECORD_ON is not defined, what is recorded is not even compiled. */
int record_off(void);
int record_off(void) {
    SCB_RECORD(this is no C, nor C++;)
    return 0;
}
