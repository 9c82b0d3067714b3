! Answers `jointproof check --formula {id} --valid-only -- PROGRAM` with a routine {routine}:
!
!     gfortran -std=legacy this.f90 {file}
!
{notes}
! What the interface has no place for is answered by `-`.
program answer
    implicit none
    integer, parameter :: dp = kind(1.0d0), inputs = {inputs}, outputs = {outputs}
    real(dp) :: x(inputs), y(outputs), jacobian(outputs, inputs)
    logical :: is_known(outputs, inputs)
    integer :: status, row, column
    do
        read (*, *, iostat=status) x
        if (status /= 0) exit
        is_known = .true.
        call ask()
        write (*, '(*(es25.16e3))', advance='no') y
        do row = 1, outputs
            do column = 1, inputs
                if (is_known(row, column)) then
                    write (*, '(es25.16e3)', advance='no') jacobian(row, column)
                else
                    write (*, '(a)', advance='no') ' -'
                end if
            end do
        end do
        write (*, '()')
        flush (6)
    end do
contains
{ask}
end program answer
